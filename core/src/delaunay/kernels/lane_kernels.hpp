// SPDX-License-Identifier: MIT
/// @file
/// The two inner loops of point insertion in 3D, with vector instructions: the walk and the growth of a cavity. The
/// four faces of a cell are tested in four lanes. Semi-static filters decide; cases that they leave open are returned
/// to the caller.
///
/// A plain loop spends its time on branches. Whether a neighbour is in conflict is unpredictable, and each
/// misprediction costs the latency of a determinant. These loops therefore compute masks and append without branches.
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
  FaceRef outer;  ///< the cavity's boundary face, as seen from the cell outside
};

/// The mesh, and the point p to be located or inserted. The infinite vertex has NaN coordinates, so filters fail.
struct LaneQuery {
  const TetMesh::Cell* cells;
  const PointRecord* points;
  Vec3 p;
  double exact_reach;  ///< plain determinants are exact if no coordinate differs from that of p by more than this
  Ownership owned;
};

/// The lists of a growing cavity. Lists of cells and of faces have room for `capacity` items each.
struct CavityLists {
  CellIndex* cells = nullptr;  ///< cells in conflict with the point; the first `n_done` have been processed
  CavityFace<3>* faces = nullptr;
  std::size_t n_cells = 0, n_done = 0, n_faces = 0, capacity = 0;
  /// Result: squared distance from the new point to the nearest vertex of the cavity, which is the nearest of all.
  double nearest = 0;
};

/// Serves the loop that grows a cavity: makes exact tests where the filters fail, and enlarges the cavity's lists.
class CavityHost {
 public:
  /// Returns a mask of the `undecided` neighbours of `cell` in conflict. `value[i]` is the determinant of neighbour i.
  virtual unsigned decide(const TetMesh::Cell& cell, unsigned undecided, const double* value) = 0;
  /// Enlarges the lists.
  virtual void enlarge(CavityLists& lists) = 0;

 protected:
  ~CavityHost() = default;
};

struct LaneKernels {
  /// Walks from cell `at` towards p as long as the next step is certain. Returns true if p is certainly strictly inside
  /// the final cell `at`; otherwise the caller continues from that cell.
  bool (*walk)(const LaneQuery& query, CellIndex& at, std::size_t& steps);
  /// Grows the cavity until all its cells are processed. Sets the bits `mark` of `flags` for its cells. Returns false
  /// if the cavity needs a cell with a vertex that another part of the parallel run owns.
  bool (*grow)(const LaneQuery& query, std::uint8_t* flags, std::uint8_t mark, CavityLists& lists, CavityHost& host);
};

namespace detail {
extern const LaneKernels baseline_kernels, avx2_kernels;
}

/// Returns the functions of the lane kernels for this processor; all versions compute the same bits.
const LaneKernels& lane_kernels();

}  // namespace geomesh
