// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/outputs/failed_place.hpp"

#include "writers/vtk_parts.hpp"

namespace geomesh::geomodel {
namespace {

std::filesystem::path write_cells(const MeshExcerpt& place, const std::filesystem::path& file) {
  std::vector<std::vector<VertexIndex>> cells;
  for (const Tetrahedron& t : place.tetrahedra) cells.push_back({t[0], t[1], t[2], t[3]});
  const std::size_t n = cells.size();
  VtkDocument document{
      "UnstructuredGrid",
      "NumberOfPoints=\"" + std::to_string(place.points.size()) + "\" NumberOfCells=\"" + std::to_string(n) + "\"",
      {},
      {},
      {vtk_points(place.points), vtk_cells("Cells", std::move(cells))}};
  constexpr int tetrahedron = 10;
  document.sections.back().arrays.push_back(
      vtk_array<std::uint8_t>("types", n, [](std::size_t) { return tetrahedron; }));
  write_vtk_document(document, Compression::small, file);
  return file;
}

/// Writes the constraints around a failed recovery. Cells are in VTK's order: vertices, lines, polygons.
std::filesystem::path write_constraints(const MeshExcerpt& place, const ModelPlc& model, const PolygonSoup& soup,
                                        const std::vector<TriangulatedSurface>& surfaces,
                                        const std::filesystem::path& file) {
  std::vector<std::vector<VertexIndex>> vertices, lines, triangles;
  for (const VertexIndex v : place.culprits) vertices.push_back({v});
  for (const auto& s : place.segments) lines.push_back({s[0], s[1]});
  for (const Triangle& t : place.triangles) triangles.push_back({t[0], t[1], t[2]});
  const std::size_t n_vertices = vertices.size(), n_lines = lines.size(), n = n_vertices + n_lines + triangles.size();
  const auto what = [=](std::size_t i) { return i < n_vertices ? 0 : i < n_vertices + n_lines ? 1 : 2; };
  const auto surface = [&, n_vertices, n_lines](std::size_t i) {
    if (i < n_vertices + n_lines) return -1;
    const Index first_soup_facet = model.facet_soup[model.facet_soup_offsets[place.facet[i - n_vertices - n_lines]]];
    return static_cast<int>(soup.origins[soup.origin_offsets[first_soup_facet]].surface);
  };
  VtkDocument document{"PolyData",
                       "NumberOfPoints=\"" + std::to_string(place.points.size()) + "\" NumberOfVerts=\"" +
                           std::to_string(n_vertices) + "\" NumberOfLines=\"" + std::to_string(n_lines) +
                           "\" NumberOfStrips=\"0\" NumberOfPolys=\"" + std::to_string(triangles.size()) + "\"",
                       {},
                       {},
                       {}};
  for (std::size_t s = 0; s < surfaces.size(); ++s)
    document.fields.push_back({"surface:" + surfaces[s].name, {static_cast<std::int32_t>(s)}});
  document.sections = {
      {"CellData", "", {vtk_array<std::int32_t>("what", n, what), vtk_array<std::int32_t>("surface", n, surface)}},
      vtk_points(place.points),
      vtk_cells("Verts", std::move(vertices)),
      vtk_cells("Lines", std::move(lines)),
      vtk_cells("Polys", std::move(triangles))};
  write_vtk_document(document, Compression::small, file);
  return file;
}

}  // namespace

std::vector<std::filesystem::path> write_failed_place(const MeshExcerpt& place, const ModelPlc& model,
                                                      const PolygonSoup& soup,
                                                      const std::vector<TriangulatedSurface>& surfaces,
                                                      const std::filesystem::path& stem) {
  return {write_cells(place, stem.string() + ".failed.vtu"),
          write_constraints(place, model, soup, surfaces, stem.string() + ".failed.vtp")};
}

}  // namespace geomesh::geomodel
