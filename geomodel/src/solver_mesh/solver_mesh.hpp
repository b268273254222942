// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The mesh in the form needed by solver files: blocks of cells of one kind, each cell in one block, and named groups
/// of blocks. All solver formats are written from this form.
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

/// One side of a face: the number of the solid (volume cell) there, from 0 (SolverMesh::n_solids), and the vertex of
/// this solid opposite the face.
struct FaceSide {
  std::uint32_t solid = no_cell;
  unsigned opposite = 0;
};

/// Cells of one shape that belong together whatever groups are requested: a region, the faces of the same surfaces
/// between the same two regions, the edges on the same curves, a named point.
struct CellBlock {
  CellShape shape;
  std::int32_t id;  ///< id of the block of cells, distinct from the ids of all other blocks
  std::string full_name;
  /// Ids of the region, the surfaces, the curves or the point to which the cells of the block belong.
  std::vector<std::int32_t> members;
  std::int32_t region_minus = 0, region_plus = 0;
  std::size_t nodes_per_cell;
  std::vector<VertexIndex> nodes;  ///< in VTK's order
  /// For blocks of faces: the volume cells on the minus side and on the plus side of each face.
  std::vector<std::array<FaceSide, 2>> sides;
  /// for blocks of faces and tetrahedra: their rows in the ModelMesh, as 32-bit numbers
  std::vector<VertexIndex> rows;
  std::size_t n_cells() const {
    if (!rows.empty()) return rows.size();
    return nodes_per_cell == 0 ? 0 : nodes.size() / nodes_per_cell;
  }
};

struct CellGroup {
  std::int32_t id;
  int dimension;
  std::string full_name;
  std::vector<std::size_t> blocks;
  std::vector<std::int32_t> members;
};

struct SolverMesh {
  const ModelMesh* source;
  /// All blocks of cells: solids (regions by id, then cohesive layers), faces, edges, points.
  std::vector<CellBlock> blocks;
  /// Groups that the options request: whole surfaces and curves, their pieces, or both. Groups may share blocks.
  std::vector<CellGroup> groups;
  /// Groups for formats in which a cell has only one number, so that no two groups share a block. Faces on several
  /// surfaces form a group of their own, named `a+b`.
  std::vector<CellGroup> labels;
  std::vector<CellGroup> region_groups;  ///< groups of regions with their names in the project
  std::vector<VertexIndex> rows;  ///< for a part of a mesh: rows of its nodes in the whole mesh; empty for a whole mesh

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

/// Converts a mesh to the form in which solver files are written. The mesh must outlive the result.
SolverMesh make_solver_mesh(const ModelMesh& mesh, const WriteOptions& options,
                            TetrahedronNodes nodes = TetrahedronNodes::listed);

/// Returns the nodes of a group of cells in ascending order.
std::vector<VertexIndex> nodes_of(const SolverMesh& mesh, const CellGroup& group);

}  // namespace geomesh::geomodel
