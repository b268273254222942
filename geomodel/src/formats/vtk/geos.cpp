// SPDX-License-Identifier: GPL-3.0-or-later
// Writes meshes for GEOS: NAME.vtm with the block `main` (NAME.geos.vtu: tetrahedra, and surfaces as triangles, cell
// array `attribute`) and one block per split fault (NAME.geos.FAULT.vtu). The latter has each face of the fault once;
// its point array `collocated_nodes` lists the rows of the main block's points at the same place, padded with -1.
// NAME.geos.xml lists blocks and surfaces. Source: the documentation of GEOS 1.0, "VTKMesh", and of its tool
// mesh_doctor.
#include <algorithm>
#include <map>
#include <tuple>

#include "formats/format_list.hpp"
#include "formats/vtk/vtu_grid.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "solver_mesh/names.hpp"
#include "solver_mesh/sidecar.hpp"
#include "writers/text_buffer.hpp"
#include "writers/written_files.hpp"

namespace geomesh::geomodel {

namespace {

using Place = std::tuple<double, double, double>;
Place place_of(const Vec3& p) { return {p.x, p.y, p.z}; }

/// The faces of a split fault, each listed once. `nodes` lists for each place on the fault all nodes of the mesh there;
/// `corners` has the corners of the faces, as positions in `nodes`.
struct Fracture {
  std::vector<std::vector<VertexIndex>> nodes;
  std::vector<std::int64_t> corners;
  std::vector<std::size_t> faces;  ///< rows of the mesh faces on the minus side of the fault
  std::size_t most_nodes = 1;
};

Fracture fracture_of(const ModelMesh& mesh, std::int32_t minus_side,
                     const std::map<Place, std::vector<VertexIndex>>& nodes_at) {
  Fracture fracture;
  std::map<Place, std::int64_t> row;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& set = mesh.surface_sets[static_cast<std::size_t>(mesh.faces[f].surface_set)];
    if (std::find(set.begin(), set.end(), minus_side) == set.end()) continue;
    const Triangle& v = mesh.faces[f].vertices;
    const auto is_doubled = [&](VertexIndex a) { return nodes_at.at(place_of(mesh.points[a])).size() > 1; };
    // A face with all nodes on the tip of the fault is left out, because the fault does not open to a zone there.
    if (std::none_of(v.begin(), v.end(), is_doubled)) continue;
    fracture.faces.push_back(f);
    for (const VertexIndex a : v) {
      const auto [entry, is_new] =
          row.try_emplace(place_of(mesh.points[a]), static_cast<std::int64_t>(fracture.nodes.size()));
      if (is_new) {
        fracture.nodes.push_back(nodes_at.at(entry->first));
        fracture.most_nodes = std::max(fracture.most_nodes, fracture.nodes.back().size());
      }
      fracture.corners.push_back(entry->second);
    }
  }
  return fracture;
}

void write_fracture(const ModelMesh& mesh, const Fracture& fracture, Compression compression,
                    const std::filesystem::path& file) {
  const std::size_t n_points = fracture.nodes.size(), n_cells = fracture.faces.size(), wide = fracture.most_nodes;
  VtkDocument document;
  document.type = "UnstructuredGrid";
  document.piece_attributes =
      "NumberOfPoints=\"" + std::to_string(n_points) + "\" NumberOfCells=\"" + std::to_string(n_cells) + "\"";
  const auto node = [&](std::size_t i) {
    const auto& at = fracture.nodes[i / wide];
    return i % wide < at.size() ? static_cast<std::int64_t>(at[i % wide]) : std::int64_t{-1};
  };
  const auto coordinate = [&](std::size_t i) { return mesh.points[fracture.nodes[i / 3].front()][i % 3]; };
  document.sections = {
      {"PointData", "", {vtk_array<std::int64_t>("collocated_nodes", n_points * wide, node, static_cast<int>(wide))}},
      {"CellData",
       "",
       {vtk_array<std::int32_t>("attribute", n_cells,
                                [&](std::size_t c) { return mesh.faces[fracture.faces[c]].surface; })}},
      {"Points", "", {vtk_array<double>("Points", 3 * n_points, coordinate, 3)}},
      {"Cells",
       "",
       {vtk_array<std::int64_t>("connectivity", 3 * n_cells, [&](std::size_t i) { return fracture.corners[i]; }),
        vtk_array<std::int64_t>("offsets", n_cells, [](std::size_t c) { return 3 * (c + 1); }),
        vtk_array<std::uint8_t>("types", n_cells, [](std::size_t) { return 5; })}}};
  write_vtk_document(document, compression, file);
}

void write_main(const ModelMesh& mesh, const WriteOptions& options, const std::filesystem::path& file) {
  WriteOptions one_grid = options;
  one_grid.single_grid = true;
  one_grid.curves = false;
  one_grid.region_array = "attribute";
  const VtuLayout layout(mesh, one_grid);
  VtkDocument document = vtu_document(mesh, one_grid, layout);
  document.sections[0].attributes = "GlobalIds=\"GlobalPointIds\"";
  document.sections[0].arrays.push_back(
      vtk_array<std::int64_t>("GlobalPointIds", layout.n_nodes(), [](std::size_t i) { return i; }));
  write_vtk_document(document, options.compression, file);
}

struct Block {
  std::string name;
  std::filesystem::path file;
};

std::string index_of(const std::vector<Block>& blocks) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "<vtkMultiBlockDataSet>\n";
  for (std::size_t i = 0; i < blocks.size(); ++i)
    text += "<DataSet index=\"" + std::to_string(i) + "\" name=\"" + xml_text(blocks[i].name) + "\" file=\"" +
            xml_text(blocks[i].file.filename().string()) + "\"/>\n";
  return text + "</vtkMultiBlockDataSet>\n</VTKFile>\n";
}

/// Returns a part of a GEOS input file that names the mesh and its regions. Every block must be in a region.
std::string snippet(const ModelMesh& mesh, const std::vector<Block>& blocks, const std::string& file) {
  TextBuffer text;
  text << "<?xml version=\"1.0\"?>\n<Problem>\n  <Mesh>\n    <VTKMesh name=\"mesh\" file=\"" << xml_text(file)
       << "\" mainBlockName=\"main\" faceBlocks=\"{ ";
  for (std::size_t b = 1; b < blocks.size(); ++b) text << (b > 1 ? ", " : "") << xml_text(blocks[b].name);
  text << " }\"/>\n  </Mesh>\n  <ElementRegions>\n";
  SolverNames names(name_limit_plain);
  for (const Region& region : mesh.regions)
    text << "    <CellElementRegion name=\"" << xml_text(names.give(region.name)) << "\" cellBlocks=\"{ " << region.id
         << "_tetrahedra }\" materialList=\"{ }\"/>\n";
  for (std::size_t b = 1; b < blocks.size(); ++b)
    text << "    <SurfaceElementRegion name=\"" << xml_text(blocks[b].name) << "\" faceBlock=\""
         << xml_text(blocks[b].name) << "\" defaultAperture=\"1e-4\" materialList=\"{ }\"/>\n";
  text << "  </ElementRegions>\n  <!-- Sets of nodes of surfaces, by the number in `attribute`:\n";
  for (const NamedSurface& surface : mesh.surfaces) {
    std::string name = surface.name;  // "--" is not allowed in an XML comment
    for (std::size_t at = 0; (at = name.find("--", at)) != std::string::npos;) name.replace(at, 2, "-_");
    text << "       " << surface.id << " " << name << "\n";
  }
  text << "  -->\n</Problem>\n";
  return text.text();
}

std::vector<std::filesystem::path> write_geos(const ModelMesh& mesh, const WriteOptions& options,
                                              const std::filesystem::path& stem) {
  WrittenFiles written;
  std::vector<Block> blocks{{"main", stem.string() + ".geos.vtu"}};
  write_main(mesh, options, blocks[0].file);
  written.add(blocks[0].file);
  std::map<Place, std::vector<VertexIndex>> nodes_at;
  for (VertexIndex v = 0; v < mesh.points.size() && !options.split.empty(); ++v)
    nodes_at[place_of(mesh.points[v])].push_back(v);
  SolverNames names(name_limit_plain);
  std::vector<SidecarGroup> sidecar;
  for (const Region& r : mesh.regions) sidecar.push_back({"attribute", 3, r.id, r.name, r.name, {r.id}});
  for (const NamedSurface& s : mesh.surfaces) sidecar.push_back({"attribute", 2, s.id, s.name, s.name, {s.id}});
  for (const std::string& fault : options.split)
    for (const NamedSurface& side : mesh.surfaces) {
      if (side.name != fault + ".minus") continue;
      const std::string name = names.give(fault);
      blocks.push_back({name, stem.string() + ".geos." + name + ".vtu"});
      write_fracture(mesh, fracture_of(mesh, side.id, nodes_at), options.compression, blocks.back().file);
      written.add(blocks.back().file);
      sidecar.push_back({"block", 2, 0, name, fault, {}});
    }
  const std::filesystem::path index = stem.string() + ".vtm", input = stem.string() + ".geos.xml";
  write_text_file(index, index_of(blocks));
  written.add(index);
  write_text_file(input, snippet(mesh, blocks, index.filename().string()));
  written.add(input);
  written.add(write_sidecar(mesh, sidecar, index));
  return written.keep();
}

}  // namespace

Format geos_format() { return {"geos", {".vtm"}, "GEOS, with split nodes", {.names = false}, write_geos, nullptr}; }

}  // namespace geomesh::geomodel
