// SPDX-License-Identifier: GPL-3.0-or-later
// Writes meshes for OpenGeoSys 6: NAME.ogs.vtu with MaterialIDs from 0, and one VTU for each surface and curve. Each of
// these also gives the rows in NAME.ogs.vtu of its points and adjacent cells (bulk_node_ids, bulk_element_ids). A face
// between two regions is assigned to the element that its normal points away from (the lower region id). Source: the
// documentation of OpenGeoSys 6.5, "Boundary conditions" and "Heterogeneous meshes".
#include <algorithm>

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

/// A VTU grid of the cells of several blocks, with points of its own. The data of the cells are not copied.
class Grid {
 public:
  /// Makes a VTU grid of the cells of a group. A grid of volume cells has all points of the mesh.
  Grid(const SolverMesh& mesh, const CellGroup& group) : mesh_(mesh), has_all_points_(group.dimension == 3) {
    if (!has_all_points_) points_ = nodes_of(mesh, group);
    for (const std::size_t b : group.blocks) {
      const CellBlock& block = mesh.blocks[b];
      parts_.push_back({&block, n_cells_, n_entries_});
      n_cells_ += block.n_cells();
      n_entries_ += block.nodes.size();
    }
  }
  std::size_t n_points() const { return has_all_points_ ? mesh_.n_nodes() : points_.size(); }
  std::size_t n_cells() const { return n_cells_; }
  std::size_t n_entries() const { return n_entries_; }
  /// Converts the number of a point in the VTU grid to its row in the mesh.
  std::size_t row(std::size_t point) const { return has_all_points_ ? point : points_[point]; }
  const CellBlock& block(std::size_t cell) const { return *part(cell).block; }
  std::size_t row_in_block(std::size_t cell) const { return cell - part(cell).first_cell; }
  /// Returns the VTK offset of a cell: the end of its nodes in the list of all cells' nodes.
  std::size_t end(std::size_t cell) const {
    const Part& at = part(cell);
    return at.first_entry + (cell - at.first_cell + 1) * at.block->nodes_per_cell;
  }
  std::int64_t node(std::size_t entry) const {
    const Part& at = *(std::upper_bound(parts_.begin(), parts_.end(), entry,
                                        [](std::size_t i, const Part& p) { return i < p.first_entry; }) -
                       1);
    const VertexIndex v = at.block->nodes[entry - at.first_entry];
    return has_all_points_ ? std::int64_t{v} : std::lower_bound(points_.begin(), points_.end(), v) - points_.begin();
  }

 private:
  struct Part {
    const CellBlock* block;
    std::size_t first_cell, first_entry;
  };
  const Part& part(std::size_t cell) const {
    return *(std::upper_bound(parts_.begin(), parts_.end(), cell,
                              [](std::size_t i, const Part& p) { return i < p.first_cell; }) -
             1);
  }
  const SolverMesh& mesh_;
  bool has_all_points_;
  std::vector<VertexIndex> points_;  // for each point of the VTU grid: its row in the mesh
  std::vector<Part> parts_;
  std::size_t n_cells_ = 0, n_entries_ = 0;
};

VtkDocument document_of(const SolverMesh& mesh, const Grid& grid) {
  VtkDocument document;
  document.type = "UnstructuredGrid";
  document.piece_attributes = "NumberOfPoints=\"" + std::to_string(grid.n_points()) + "\" NumberOfCells=\"" +
                              std::to_string(grid.n_cells()) + "\"";
  document.origin = origin_of(*mesh.source);
  const auto coordinate = [&](std::size_t i) { return mesh.node(grid.row(i / 3))[i % 3]; };
  const auto type = [&](std::size_t c) { return vtk_type(grid.block(c)); };
  document.sections = {
      {"PointData", "", {}},
      {"CellData", "", {}},
      {"Points", "", {vtk_array<double>("Points", 3 * grid.n_points(), coordinate, 3)}},
      {"Cells",
       "",
       {vtk_array<std::int64_t>("connectivity", grid.n_entries(), [&](std::size_t i) { return grid.node(i); }),
        vtk_array<std::int64_t>("offsets", grid.n_cells(), [&](std::size_t c) { return grid.end(c); }),
        vtk_array<std::uint8_t>("types", grid.n_cells(), type)}}};
  return document;
}

/// Writes all volume cells, sorted by region id, with all points of the mesh.
void write_bulk(const SolverMesh& mesh, Compression compression, const std::filesystem::path& file) {
  CellGroup all{0, 3, "", {}, {}};
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    if (dimension_of(mesh.blocks[b].shape) == 3) all.blocks.push_back(b);
  const Grid grid(mesh, all);
  VtkDocument document = document_of(mesh, grid);
  add_region_fields(*mesh.source, document.fields);
  VtkSection& data = document.sections[1];
  data.attributes = "Scalars=\"MaterialIDs\"";
  data.arrays.push_back(
      vtk_array<std::int32_t>("MaterialIDs", grid.n_cells(), [&](std::size_t c) { return grid.block(c).id - 1; }));
  const ModelMesh& model = *mesh.source;
  const auto n_regions = static_cast<std::int32_t>(model.regions.size());
  for (const RegionAttribute& attribute : model.attributes)
    data.arrays.push_back(vtk_array<double>(attribute.name, grid.n_cells(), [&, n_regions](std::size_t c) {
      const std::int32_t id = grid.block(c).id;
      return id <= n_regions ? attribute.by_region[static_cast<std::size_t>(id - 1)] : 0.0;
    }));
  write_vtk_document(document, compression, file);
}

void write_subset(const SolverMesh& mesh, const CellGroup& group, Compression compression,
                  const std::filesystem::path& file) {
  const Grid grid(mesh, group);
  VtkDocument document = document_of(mesh, grid);
  document.sections[0].arrays.push_back(
      vtk_array<std::uint64_t>("bulk_node_ids", grid.n_points(), [&](std::size_t i) { return grid.row(i); }));
  const auto element = [&](std::size_t c) {
    const auto& [minus, plus] = grid.block(c).sides[grid.row_in_block(c)];
    return minus.solid != no_cell ? minus.solid : plus.solid;
  };
  if (group.dimension == 2 && grid.n_cells() > 0)
    document.sections[1].arrays.push_back(vtk_array<std::uint64_t>("bulk_element_ids", grid.n_cells(), element));
  write_vtk_document(document, compression, file);
}

std::vector<std::filesystem::path> write_opengeosys(const ModelMesh& model, const WriteOptions& options,
                                                    const std::filesystem::path& stem) {
  SolverMesh mesh = make_solver_mesh(model, options);
  // OpenGeoSys files are written without the rows of cells in the mesh, which take a quarter of the memory of the mesh.
  for (CellBlock& block : mesh.blocks) block.rows = {};
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
          write_opengeosys,
          nullptr,
          write_ogs_starter};
}

}  // namespace geomesh::geomodel
