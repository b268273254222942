// SPDX-License-Identifier: GPL-3.0-or-later
// OpenGeoSys 6: NAME.ogs.vtu with MaterialIDs from 0, and one VTU a surface and curve with the rows of its points and
// cells in it (bulk_node_ids, bulk_element_ids). A face between two regions is given at the element that its normal
// points away from (the lower region id). Followed: the documentation of OpenGeoSys 6.5, "Boundary conditions" and
// "Heterogeneous meshes".
#include <algorithm>
#include <map>

#include "formats/format_list.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "solver_mesh/names.hpp"
#include "solver_mesh/sidecar.hpp"
#include "solver_mesh/solver_mesh.hpp"
#include "starters/starters.hpp"
#include "writers/vtk_names.hpp"
#include "writers/vtk_xml.hpp"
#include "writers/written_files.hpp"

namespace geomesh::geomodel {

namespace {

std::uint8_t vtk_type(const CellBlock& block) {
  switch (block.shape) {
    case CellShape::vertex:
      return 1;
    case CellShape::edge:
      return block.nodes_per_cell == 3 ? 21 : 3;
    case CellShape::triangle:
      return block.nodes_per_cell == 6 ? 22 : 5;
    case CellShape::tetrahedron:
      return block.nodes_per_cell == 10 ? 24 : 10;
    case CellShape::prism:
      break;
  }
  return 13;
}

/// Cells of some blocks, all in one grid with points of its own.
struct Grid {
  std::vector<VertexIndex> points;  ///< rows in the mesh
  std::vector<std::int64_t> nodes, ends;
  std::vector<std::uint8_t> types;
  std::vector<std::uint64_t> bulk_elements;
};

Grid grid_of(const SolverMesh& mesh, const CellGroup& group) {
  Grid grid;
  grid.points = nodes_of(mesh, group);
  for (const std::size_t b : group.blocks) {
    const CellBlock& block = mesh.blocks[b];
    for (std::size_t c = 0; c < block.n_cells(); ++c) {
      for (std::size_t i = 0; i < block.nodes_per_cell; ++i) {
        const VertexIndex v = block.nodes[c * block.nodes_per_cell + i];
        grid.nodes.push_back(std::lower_bound(grid.points.begin(), grid.points.end(), v) - grid.points.begin());
      }
      grid.ends.push_back(static_cast<std::int64_t>(grid.nodes.size()));
      grid.types.push_back(vtk_type(block));
      if (block.shape != CellShape::triangle) continue;
      const auto& [minus, plus] = block.sides[c];
      grid.bulk_elements.push_back(minus.solid != no_cell ? minus.solid : plus.solid);
    }
  }
  return grid;
}

VtkDocument document_of(const SolverMesh& mesh, const Grid& grid) {
  VtkDocument document;
  document.type = "UnstructuredGrid";
  document.piece_attributes = "NumberOfPoints=\"" + std::to_string(grid.points.size()) + "\" NumberOfCells=\"" +
                              std::to_string(grid.types.size()) + "\"";
  document.origin = origin_of(*mesh.source);
  document.sections = {
      {"PointData", "", {}},
      {"CellData", "", {}},
      {"Points",
       "",
       {vtk_array<double>(
           "Points", 3 * grid.points.size(), [&](std::size_t i) { return mesh.node(grid.points[i / 3])[i % 3]; }, 3)}},
      {"Cells",
       "",
       {vtk_array<std::int64_t>("connectivity", grid.nodes.size(), [&](std::size_t i) { return grid.nodes[i]; }),
        vtk_array<std::int64_t>("offsets", grid.ends.size(), [&](std::size_t i) { return grid.ends[i]; }),
        vtk_array<std::uint8_t>("types", grid.types.size(), [&](std::size_t i) { return grid.types[i]; })}}};
  return document;
}

/// All solids, regions by id; its points are those of the mesh.
void write_bulk(const SolverMesh& mesh, Compression compression, const std::filesystem::path& file) {
  CellGroup all{0, 3, "", {}, {}};
  std::vector<std::size_t> block_of;  // by cell
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    if (dimension_of(mesh.blocks[b].shape) == 3) {
      all.blocks.push_back(b);
      block_of.insert(block_of.end(), mesh.blocks[b].n_cells(), b);
    }
  const Grid grid = grid_of(mesh, all);
  VtkDocument document = document_of(mesh, grid);
  add_region_fields(*mesh.source, document.fields);
  VtkSection& data = document.sections[1];
  data.attributes = "Scalars=\"MaterialIDs\"";
  data.arrays.push_back(vtk_array<std::int32_t>("MaterialIDs", block_of.size(),
                                                [&](std::size_t c) { return mesh.blocks[block_of[c]].id - 1; }));
  const ModelMesh& model = *mesh.source;
  const auto n_regions = static_cast<std::int32_t>(model.regions.size());
  for (const RegionAttribute& attribute : model.attributes)
    data.arrays.push_back(vtk_array<double>(attribute.name, block_of.size(), [&, n_regions](std::size_t c) {
      const std::int32_t id = mesh.blocks[block_of[c]].id;
      return id <= n_regions ? attribute.by_region[static_cast<std::size_t>(id - 1)] : 0.0;
    }));
  write_vtk_document(document, compression, file);
}

void write_subset(const SolverMesh& mesh, const CellGroup& group, Compression compression,
                  const std::filesystem::path& file) {
  const Grid grid = grid_of(mesh, group);
  VtkDocument document = document_of(mesh, grid);
  document.sections[0].arrays.push_back(
      vtk_array<std::uint64_t>("bulk_node_ids", grid.points.size(), [&](std::size_t i) { return grid.points[i]; }));
  if (!grid.bulk_elements.empty())
    document.sections[1].arrays.push_back(vtk_array<std::uint64_t>(
        "bulk_element_ids", grid.bulk_elements.size(), [&](std::size_t i) { return grid.bulk_elements[i]; }));
  write_vtk_document(document, compression, file);
}

std::vector<std::filesystem::path> write(const ModelMesh& model, const WriteOptions& options,
                                         const std::filesystem::path& stem) {
  const SolverMesh mesh = make_solver_mesh(model, options);
  WrittenFiles written;
  const std::filesystem::path bulk = stem.string() + ".ogs.vtu";
  write_bulk(mesh, options.compression, bulk);
  written.add(bulk);
  SolverNames names(name_limit_plain);
  std::vector<SidecarGroup> sidecar;
  for (const CellGroup& group : mesh.groups) {
    if (group.dimension == 3) {
      sidecar.push_back({"MaterialIDs", 3, group.id, std::to_string(group.id - 1), group.full_name, group.members});
      continue;
    }
    const std::string name = names.give(group.full_name);
    const std::filesystem::path file = stem.string() + ".ogs." + name + ".vtu";
    write_subset(mesh, group, options.compression, file);
    written.add(file);
    sidecar.push_back({"mesh", group.dimension, 0, file.filename().string(), group.full_name, group.members});
  }
  written.add(write_sidecar(model, sidecar, bulk));
  return written.keep();
}

}  // namespace

Format ogs_format() {
  return {"ogs",
          {".ogs.vtu"},
          "OpenGeoSys 6",
          {.second_order = true, .prisms = true, .curves = true, .overlapping = true},
          write,
          nullptr,
          write_ogs_starter};
}

}  // namespace geomesh::geomodel
