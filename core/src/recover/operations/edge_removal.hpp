// SPDX-License-Identifier: MIT
/// @file
/// Removal of a mesh edge by flips, without adding a point: the n cells around the edge are replaced by 2(n-2) cells
/// (3-2 and 4-4 flips are n = 3 and 4). EdgeShell finds a triangulation of the ring that gives positive cells; if there
/// is none, edges of the ring's cells are removed first, recursively, to make the ring smaller (the n-to-m flips of Si
/// 2015, "TetGen", section 4.2; own design).
#pragma once

#include "recover/model/constrained_mesh.hpp"
#include "recover/model/constraints.hpp"
#include "recover/model/recovery_budget.hpp"

namespace geomesh::recover {

/// Decides which vertices must not be connected by a new edge when an edge is removed by flips.
class EdgeRule {
 public:
  virtual ~EdgeRule() = default;
  virtual bool forbids(VertexIndex a, VertexIndex b) const = 0;
};

class EdgeRemover {
 public:
  /// `work_left` counts down the edges and faces that all calls together may try to remove; null: no limit.
  EdgeRemover(ConstrainedMesh& mesh, const Constraints& constraints, std::size_t* work_left = nullptr)
      : mesh_(mesh), constraints_(constraints), work_left_(work_left) {}

  /// Removes edge p-q, with `depth` levels of recursion. Rejects subsegments and edges of locked faces. Returns false
  /// if the mesh is unchanged (up to slot numbers). `rule` may be null. `budget` limits the edges tried in this call.
  /// `hint`: see ConstrainedMesh::find_edge.
  bool remove(VertexIndex p, VertexIndex q, unsigned depth, const EdgeRule* rule = nullptr,
              unsigned budget = most_edges, CellIndex hint = no_cell);

  /// Applies a 2-3 flip to a face; returns false if it is locked, a new cell would not be positive, or no work is left.
  bool flip_face(FaceRef f);

  static constexpr std::size_t max_ring = recovery_budget.ring;
  static constexpr unsigned most_edges = 2000;  ///< number of edges that one call of remove() tries to remove

 private:
  bool spend();
  bool remove_at(VertexIndex p, VertexIndex q, CellIndex hint, unsigned depth, VertexIndex ear);
  bool replace_ring(const EdgeRing& ring, VertexIndex ear);
  bool is_fixed(const EdgeRing& ring) const;
  bool shrink_ring(const EdgeRing& ring, unsigned depth);

  ConstrainedMesh& mesh_;
  const Constraints& constraints_;
  std::size_t* work_left_;
  const EdgeRule* rule_ = nullptr;
  unsigned budget_ = 0;
  std::vector<EdgeRing> rings_;  ///< cells and vertices around the edge that is removed, by depth of recursion
  std::vector<Tetrahedron> filling_;
};

}  // namespace geomesh::recover
