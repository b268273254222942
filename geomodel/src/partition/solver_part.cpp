// SPDX-License-Identifier: GPL-3.0-or-later
#include "partition/solver_part.hpp"

#include <algorithm>

namespace geomesh::geomodel {

namespace {

/// Solids (volume cells) of a mesh, numbered block by block, and their numbers in one part of the mesh.
struct Solids {
  std::vector<std::size_t> row;  ///< for each solid (volume cell): the row of its tetrahedron
  /// Number of each solid (volume cell) in the mesh part, or no_cell if the part does not have it.
  std::vector<std::uint32_t> local;
};

Solids solids_of(const SolverMesh& whole, const MeshPart& part) {
  Solids solids;
  for (const CellBlock& block : whole.blocks)
    if (dimension_of(block.shape) == 3) solids.row.insert(solids.row.end(), block.rows.begin(), block.rows.end());
  std::vector<std::size_t> kept = part.cells;
  std::sort(kept.begin(), kept.end());
  std::uint32_t next = 0;
  for (const std::size_t row : solids.row)
    solids.local.push_back(std::binary_search(kept.begin(), kept.end(), row) ? next++ : no_cell);
  return solids;
}

class PartCutter {
 public:
  PartCutter(const SolverMesh& whole, const MeshParts& parts, MeshPart part) : whole_(whole), parts_(parts) {
    result_.part = std::move(part);
    result_.mesh.source = whole.source;
    result_.mesh.groups = whole.groups;
    result_.mesh.labels = whole.labels;
    result_.mesh.region_groups = whole.region_groups;
    result_.mesh.rows = result_.part.nodes;
    solids_ = solids_of(whole, result_.part);
  }

  SolverPart cut() {
    std::size_t solid = 0;
    for (const CellBlock& block : whole_.blocks) {
      begin(block);
      for (std::size_t c = 0; c < block.n_cells(); ++c) {
        const int dimension = dimension_of(block.shape);
        if (dimension == 3) {
          if (solids_.local[solid] != no_cell) add(block, c, parts_.part_of_cell(solids_.row[solid]));
          ++solid;
        } else if (dimension == 2) {
          add_face(block, c);
        } else {
          add_lower(block, c);
        }
      }
    }
    return std::move(result_);
  }

 private:
  void begin(const CellBlock& block) {
    CellBlock empty = block;
    empty.nodes.clear();
    empty.sides.clear();
    empty.rows.clear();
    result_.mesh.blocks.push_back(std::move(empty));
    result_.cells.emplace_back();
    result_.owner.emplace_back();
  }
  void add(const CellBlock& block, std::size_t c, std::int32_t owner) {
    CellBlock& cut = result_.mesh.blocks.back();
    for (std::size_t i = 0; i < block.nodes_per_cell; ++i)
      cut.nodes.push_back(result_.part.local(block.nodes[c * block.nodes_per_cell + i]));
    if (!block.rows.empty()) cut.rows.push_back(block.rows[c]);
    result_.cells.back().push_back(c);
    result_.owner.back().push_back(owner);
  }
  void add_face(const CellBlock& block, std::size_t c) {
    std::array<FaceSide, 2> sides = block.sides[c];
    const std::size_t first = sides[0].solid != no_cell ? sides[0].solid : sides[1].solid;
    bool is_here = false;
    for (FaceSide& side : sides)
      if (side.solid != no_cell) {
        side.solid = solids_.local[side.solid];
        is_here = is_here || side.solid != no_cell;
      }
    if (!is_here) return;
    add(block, c, parts_.part_of_cell(solids_.row[first]));
    result_.mesh.blocks.back().sides.push_back(sides);
  }
  void add_lower(const CellBlock& block, std::size_t c) {
    std::int32_t owner = parts_.n_parts();
    for (std::size_t i = 0; i < block.nodes_per_cell; ++i) {
      const VertexIndex v = block.nodes[c * block.nodes_per_cell + i];
      if (result_.part.local(v) == no_vertex) return;
      owner = std::min(owner, parts_.owner_of_node(v));
    }
    add(block, c, owner);
  }

  const SolverMesh& whole_;
  const MeshParts& parts_;
  Solids solids_;
  SolverPart result_;
};

}  // namespace

SolverPart part_of(const SolverMesh& whole, const MeshParts& parts, std::int32_t number, Ghosts ghosts) {
  return PartCutter(whole, parts, parts.part(number, ghosts)).cut();
}

std::vector<VertexIndex> nodes_in_part(const std::vector<VertexIndex>& nodes_of_whole, const MeshPart& part) {
  std::vector<VertexIndex> nodes;
  for (const VertexIndex v : nodes_of_whole)
    if (const VertexIndex local = part.local(v); local != no_vertex) nodes.push_back(local);
  return nodes;
}

}  // namespace geomesh::geomodel
