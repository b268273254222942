// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/outputs/soup_vtp.hpp"

#include "writers/vtk_parts.hpp"

namespace geomesh::geomodel {
namespace {

std::string piece_attributes(std::size_t n_points, std::size_t n_verts, std::size_t n_lines, std::size_t n_polys) {
  return "NumberOfPoints=\"" + std::to_string(n_points) + "\" NumberOfVerts=\"" + std::to_string(n_verts) +
         "\" NumberOfLines=\"" + std::to_string(n_lines) + "\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
         std::to_string(n_polys) + "\"";
}

std::filesystem::path write(const VtkDocument& document, const std::filesystem::path& file) {
  write_vtk_document(document, Compression::small, file);
  return file;
}

/// Returns `value(origin)` for the origins of all facets of the polygon soup, as a list.
template <class F>
VtkField field_of_origins(const char* name, const PolygonSoup& soup, F value) {
  VtkField field{name, {}};
  for (const auto& origin : soup.origins) field.values.push_back(static_cast<std::int32_t>(value(origin)));
  return field;
}

std::filesystem::path write_soup(const PolygonSoup& soup, const std::vector<TriangulatedSurface>& surfaces,
                                 const std::filesystem::path& file) {
  VtkDocument document{"PolyData", piece_attributes(soup.points.size(), 0, 0, soup.facets.size()), {}, {}, {}};
  for (std::size_t s = 0; s < surfaces.size(); ++s)
    document.fields.push_back({"surface:" + surfaces[s].name, {static_cast<std::int32_t>(s)}});
  document.fields.push_back({"origin_offsets", {soup.origin_offsets.begin(), soup.origin_offsets.end()}});
  document.fields.push_back(field_of_origins("origin_surfaces", soup, [](const auto& o) { return o.surface; }));
  document.fields.push_back(field_of_origins("origin_triangles", soup, [](const auto& o) { return o.triangle; }));
  const auto first = [&](std::size_t f) { return soup.origins[soup.origin_offsets[f]]; };
  const std::size_t n = soup.facets.size();
  std::vector<std::vector<VertexIndex>> triangles;
  for (const Triangle& t : soup.facets) triangles.push_back({t[0], t[1], t[2]});
  document.sections = {
      {"PointData",
       "",
       {vtk_array<std::int32_t>("kind", soup.points.size(),
                                [&](std::size_t v) { return static_cast<int>(soup.kind[v]); })}},
      {"CellData",
       "",
       {vtk_array<std::int32_t>("surface", n, [&](std::size_t f) { return first(f).surface; }),
        vtk_array<std::int32_t>("source_triangle", n, [&](std::size_t f) { return first(f).triangle; }),
        vtk_array<std::int32_t>("n_origins", n,
                                [&](std::size_t f) { return soup.origin_offsets[f + 1] - soup.origin_offsets[f]; })}},
      vtk_points(soup.points),
      vtk_cells("Polys", std::move(triangles))};
  return write(document, file);
}

/// Writes the edges of curves as lines. An edge on several curves is written once for each of them.
std::filesystem::path write_curves(const ModelPlc& model, const std::filesystem::path& file) {
  std::vector<std::vector<VertexIndex>> lines;
  std::vector<Index> curve;
  for (std::size_t s = 0; s < model.plc.segments.size(); ++s)
    for (const Index c : model.segment_curves[s]) {
      lines.push_back({model.plc.segments[s].a, model.plc.segments[s].b});
      curve.push_back(c);
    }
  VtkDocument document{"PolyData", piece_attributes(model.plc.points.size(), 0, lines.size(), 0), {}, {}, {}};
  for (std::size_t c = 0; c < model.curves.size(); ++c)
    document.fields.push_back(
        {"curve:" + model.curves[c].kind + " " + model.curves[c].name, {static_cast<std::int32_t>(c)}});
  document.sections = {
      {"CellData", "", {vtk_array<std::int32_t>("curve", curve.size(), [&](std::size_t i) { return curve[i]; })}},
      vtk_points(model.plc.points),
      vtk_cells("Lines", std::move(lines))};
  return write(document, file);
}

std::filesystem::path write_spots(const std::vector<Spot>& spots, const std::vector<TriangulatedSurface>& surfaces,
                                  const std::filesystem::path& file) {
  const std::size_t n = spots.size();
  std::vector<Vec3> places;
  std::vector<std::vector<VertexIndex>> cells;
  for (const Spot& spot : spots) {
    cells.push_back({static_cast<VertexIndex>(places.size())});
    places.push_back(spot.place);
  }
  const auto name = [&](Index s) { return s < surfaces.size() ? surfaces[s].name : std::string(); };
  VtkDocument document{"PolyData", piece_attributes(n, n, 0, 0), {}, {}, {}};
  document.sections = {{"CellData",
                        "",
                        {vtk_texts("what", n, [&](std::size_t i) { return spots[i].what; }),
                         vtk_texts("surface_a", n, [&](std::size_t i) { return name(spots[i].surface_a); }),
                         vtk_texts("surface_b", n, [&](std::size_t i) { return name(spots[i].surface_b); }),
                         vtk_array<std::int32_t>("count", n, [&](std::size_t i) { return spots[i].count; }),
                         vtk_array<double>("measure", n, [&](std::size_t i) { return spots[i].measure; }),
                         vtk_texts("description", n, [&](std::size_t i) { return describe(spots[i], surfaces); })}},
                       vtk_points(places),
                       vtk_cells("Verts", std::move(cells))};
  return write(document, file);
}

}  // namespace

std::vector<std::filesystem::path> write_soup_vtp(const ArrangementResult& arrangement, const ModelPlc& plc,
                                                  const std::vector<TriangulatedSurface>& surfaces,
                                                  const std::filesystem::path& stem) {
  return {write_soup(arrangement.soup, surfaces, stem.string() + ".soup.vtp"),
          write_curves(plc, stem.string() + ".soup.curves.vtp"),
          write_spots(arrangement.spots, surfaces, stem.string() + ".spots.vtp")};
}

}  // namespace geomesh::geomodel
