// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The mesh in the form needed by solver files: blocks of cells of one kind, each cell in one block, and named groups
/// of blocks. Every solver format is written from this.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"
#include "geomesh/geomodel/write_options.hpp"

namespace geomesh::geomodel {

enum class CellShape { vertex, edge, triangle, tetrahedron, prism };
int dimension_of(CellShape shape);

inline constexpr std::uint32_t no_cell = std::numeric_limits<std::uint32_t>::max();

/// The position of a face at a solid: the solid's number from 0 (SolverMesh::n_solids), and the vertex opposite the
/// face.
struct FaceSide {
  std::uint32_t solid = no_cell;
  unsigned opposite = 0;
};

/// Cells of one shape that belong together whatever groups are requested: a region, the faces of the same surfaces
/// between the same two regions, the edges on the same curves, a named point.
struct CellBlock {
  CellShape shape;
  std::int32_t id;  ///< id, distinct for all blocks
  std::string full_name;
  std::vector<std::int32_t> members;  ///< ids of the region, surfaces, curves or the point
  std::int32_t region_minus = 0, region_plus = 0;
  std::size_t nodes_per_cell;
  std::vector<VertexIndex> nodes;              ///< in VTK's order
  std::vector<std::array<FaceSide, 2>> sides;  ///< for faces: minus side, plus side
  std::vector<VertexIndex> rows;  ///< for faces and tetrahedra: rows in the ModelMesh, which have 32 bits too
  std::size_t n_cells() const {
    if (!rows.empty()) return rows.size();
    return nodes_per_cell == 0 ? 0 : nodes.size() / nodes_per_cell;
  }
};

/// A named group of blocks.
struct CellGroup {
  std::int32_t id;
  int dimension;
  std::string full_name;
  std::vector<std::size_t> blocks;
  std::vector<std::int32_t> members;
};

struct SolverMesh {
  const ModelMesh* source;
  std::vector<CellBlock> blocks;  ///< solids (regions by id, then cohesive layers), faces, edges, points
  /// The requested groups: whole surfaces and curves, their pieces, or both; two groups may share blocks.
  std::vector<CellGroup> groups;
  /// Groups for formats in which a cell has one number: no two share a block. Faces on several surfaces form a group of
  /// their own, named `a+b`.
  std::vector<CellGroup> labels;
  std::vector<CellGroup> region_groups;  ///< groups of regions as named in the project
  std::vector<VertexIndex> rows;         ///< for a part of a mesh: its nodes; empty for a whole mesh

  std::size_t n_nodes() const {
    return rows.empty() ? source->points.size() + source->midpoints.points.size() : rows.size();
  }
  const Vec3& node(std::size_t i) const {
    const std::size_t n = source->points.size(), row = rows.empty() ? i : rows[i];
    return row < n ? source->points[row] : source->midpoints.points[row - n];
  }
  std::size_t n_solids() const { return count(3); }
  std::size_t count(int dimension) const;
  bool second_order() const { return !source->midpoints.empty(); }
};

/// Whether blocks of tetrahedra store their nodes, or only their rows, which takes a fifth of the memory.
enum class TetrahedronNodes { listed, by_rows };

/// The mesh must outlive the result.
SolverMesh make_solver_mesh(const ModelMesh& mesh, const WriteOptions& options,
                            TetrahedronNodes nodes = TetrahedronNodes::listed);

/// Returns the nodes of a group in ascending order.
std::vector<VertexIndex> nodes_of(const SolverMesh& mesh, const CellGroup& group);

}  // namespace geomesh::geomodel
