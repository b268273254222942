// SPDX-License-Identifier: MIT
/// @file
/// The two inner loops of insertion in space: the walk and the growth of a cavity. The four faces of a cell stand in
/// four lanes. Semi-static filters decide; what they leave open goes back to the caller.
///
/// A plain loop spends its time on branches. Whether a neighbour is in conflict is as good as random, and each wrong
/// guess costs the depth of a determinant. So these loops compute masks and append to lists without branching on them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "delaunay/kernels/point_record.hpp"
#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh {

/// Face of a cavity as seen from inside, in the order that makes (vertices, new point) positive.
template <unsigned Dim>
struct CavityFace {
  std::array<VertexIndex, Dim> vertices;
  FaceRef outer;  ///< the face as seen from outside the cavity
};

/// What both loops read. Coordinates of the infinite vertex are NaN, so that no filter decides about it.
struct LaneQuery {
  const TetMesh::Cell* cells;
  const PointRecord* points;
  Vec3 p;
  double exact_reach;  ///< plain determinants are exact where no coordinate differs from p's by more
  Ownership owned;
};

/// The lists that a cavity grows in; both have room for `capacity` items.
struct CavityLists {
  CellIndex* cells = nullptr;  ///< cells in conflict; those before `n_done` have been looked at
  CavityFace<3>* faces = nullptr;
  std::size_t n_cells = 0, n_done = 0, n_faces = 0, capacity = 0;
  double nearest =
      0;  ///< when grown: least squared distance from the point to a vertex of the cavity, which has the nearest of all
};

/// Answers what the loop cannot.
class CavityHost {
 public:
  /// Which of the `undecided` neighbours of `cell` are in conflict; `value[i]` is the determinant for neighbour i in
  /// doubles.
  virtual unsigned decide(const TetMesh::Cell& cell, unsigned undecided, const double* value) = 0;
  /// Makes room for more.
  virtual void enlarge(CavityLists& lists) = 0;

 protected:
  ~CavityHost() = default;
};

struct LaneKernels {
  /// Walks from `at` towards p while the next step is certain. True where p is certainly strictly inside the cell `at`
  /// that it ends in; else the caller goes on from there.
  bool (*walk)(const LaneQuery& query, CellIndex& at, std::size_t& steps);
  /// Grows the cavity until all its cells are done. `flags & mark` is set in its cells. False where it needs a cell
  /// with a vertex that is not owned.
  bool (*grow)(const LaneQuery& query, std::uint8_t* flags, std::uint8_t mark, CavityLists& lists, CavityHost& host);
};

namespace detail {
extern const LaneKernels baseline_kernels, avx2_kernels;
}

/// The version for this machine; all compute the same bits.
const LaneKernels& lane_kernels();

}  // namespace geomesh
