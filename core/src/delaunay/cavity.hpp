// SPDX-License-Identifier: MIT
/// @file
/// Insertion of one point by the cavity algorithm of Bowyer (1981) and Watson (1981) (Cavalcanti and Mello 1999, section 2.1): locate, find
/// the conflict zone, stellate.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geomesh/core/locate.hpp"
#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh {

/// Works on a Delaunay mesh with ghost cells. With the exact, perturbed in-sphere test the cavity is star-shaped about the new point
/// (the paper's equation 1), which stellate() relies on.
class CavityInserter {
 public:
  CavityInserter(TetMesh& mesh, std::span<const Vec3> points) : mesh_(mesh), points_(points) {}

  /// Four affinely independent points, positively oriented; the mesh must be empty. Makes one finite cell and four ghosts.
  void start(const Tetrahedron& first);
  /// Inserts point v, which differs from all inserted points. Returns a new cell.
  void insert(VertexIndex v);

  std::size_t walk_steps() const { return walk_steps_; }

 private:
  struct BoundaryFace {
    FaceRef inside;  ///< face of a cavity cell
  };
  bool in_conflict(CellIndex c, VertexIndex v) const;
  void find_conflict_zone(CellIndex first, VertexIndex v);
  void stellate(VertexIndex v);
  void link_by_edge(VertexIndex a, VertexIndex b, FaceRef f);

  static constexpr std::uint8_t conflict_flag = 1;

  TetMesh& mesh_;
  std::span<const Vec3> points_;
  WalkRandom random_;
  CellIndex hint_ = no_cell;
  std::vector<CellIndex> cavity_;
  std::vector<BoundaryFace> boundary_;
  struct EdgeSlot {
    std::uint64_t key = 0;
    std::uint32_t epoch = 0;
    FaceRef face;
  };
  std::vector<EdgeSlot> edges_ = std::vector<EdgeSlot>(1024);
  std::uint32_t epoch_ = 0;
  std::size_t walk_steps_ = 0;
};

}  // namespace geomesh
