// SPDX-License-Identifier: MIT
/// @file
/// The two inner loops of insertion in space: the walk and the growth of a cavity. The four faces of a cell are in four
/// lanes. Semi-static filters decide; undecided cases are returned to the caller.
///
/// A plain loop spends its time on branches. Whether a neighbour is in conflict is unpredictable, and each
/// misprediction costs the latency of a determinant. These loops therefore compute masks and append to lists without
/// branches.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "delaunay/kernels/point_record.hpp"
#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh {

/// A face of a cavity as seen from inside, in the order that makes (vertices, new point) positive.
template <unsigned Dim>
struct CavityFace {
  std::array<VertexIndex, Dim> vertices;
  FaceRef outer;  ///< the face as seen from outside the cavity
};

/// The input of both loops. Coordinates of the infinite vertex are NaN, so that no filter decides about it.
struct LaneQuery {
  const TetMesh::Cell* cells;
  const PointRecord* points;
  Vec3 p;
  double exact_reach;  ///< plain determinants are exact if no coordinate differs from p's by more than this
  Ownership owned;
};

/// The lists of a growing cavity; both have room for `capacity` items.
struct CavityLists {
  CellIndex* cells = nullptr;  ///< cells in conflict; those before `n_done` have been processed
  CavityFace<3>* faces = nullptr;
  std::size_t n_cells = 0, n_done = 0, n_faces = 0, capacity = 0;
  /// When grown: least squared distance from the point to a vertex of the cavity, which contains the nearest vertex of
  /// all.
  double nearest = 0;
};

/// Decides the cases that the loop cannot.
class CavityHost {
 public:
  /// Returns which of the `undecided` neighbours of `cell` are in conflict; `value[i]` is the determinant for neighbour
  /// i in doubles.
  virtual unsigned decide(const TetMesh::Cell& cell, unsigned undecided, const double* value) = 0;
  /// Enlarges the lists.
  virtual void enlarge(CavityLists& lists) = 0;

 protected:
  ~CavityHost() = default;
};

struct LaneKernels {
  /// Walks from `at` towards p as long as the next step is certain. Returns true if p is certainly strictly inside the
  /// final cell `at`; otherwise the caller continues from there.
  bool (*walk)(const LaneQuery& query, CellIndex& at, std::size_t& steps);
  /// Grows the cavity until all its cells are processed. Sets `flags & mark` in its cells. Returns false if it needs a
  /// cell with a vertex that is not owned.
  bool (*grow)(const LaneQuery& query, std::uint8_t* flags, std::uint8_t mark, CavityLists& lists, CavityHost& host);
};

namespace detail {
extern const LaneKernels baseline_kernels, avx2_kernels;
}

/// Returns the version for this machine; all versions compute the same bits.
const LaneKernels& lane_kernels();

}  // namespace geomesh
