// SPDX-License-Identifier: MIT
/// @file
/// Inserts all points by the cavity algorithm: in rounds in spatial order, large rounds in concurrent parts, and
/// clustered points last.
#pragma once

#include <cstddef>
#include <vector>

#include "delaunay/cavity_insertion.hpp"
#include "delaunay/space3.hpp"
#include "delaunay/twins.hpp"
#include "geomesh/core/delaunay.hpp"
#include "geomesh/core/run_context.hpp"

namespace geomesh {

/// Parallel insertion after the idea of HXT (Marot, Pellerin and Remacle 2019, "One machine, one minute, three billion
/// tetrahedra"). Each part inserts the points of one interval of the Hilbert curve. It may only change cells with all
/// of their vertices in this interval; a point that needs other cells is deferred. Unlike in HXT, the parts depend only
/// on the number of points, and each takes slots for new cells from stripes of its own. The work of a part, and every
/// byte of the result, are therefore the same for any number of threads. No locks are needed.
///
/// No two parts interfere: a cell that a part removes has all its vertices in that part, and shares three vertices with
/// each neighbour. A neighbour not owned by the part has therefore at least two finite vertices in it, so no other part
/// owns it either: its vertices do not change, and each of its neighbour links is written by at most one part.
class CavityStage {
 public:
  CavityStage(TetMesh& mesh, PointRecord* records, VertexIndex n_points, double unit, double cluster_distance,
              const RunContext& context);

  void start(const Tetrahedron& first) { sequential_.start(first); }
  /// Inserts the points at positions [begin, end) of the insertion order, which are sorted along the Hilbert curve.
  void insert_round(VertexIndex begin, VertexIndex end);
  /// Inserts the points that were deferred because they were too close to others. The triangulation is then complete.
  void insert_waiting();
  /// Removes the mesh's unused slots and writes the statistics of insertion.
  void finish(DelaunayStatistics& statistics);

  const std::vector<Twin>& twins() const { return twins_; }

 private:
  using Part = CavityInsertion<Space3, true>;

  void insert_all(const std::vector<VertexIndex>& positions, double distance);
  std::vector<VertexIndex> insert_in_parts(const std::vector<VertexIndex>& positions, double distance);
  void insert_one_by_one(const std::vector<VertexIndex>& positions, double distance);
  std::size_t start_part(Part& part, const std::vector<VertexIndex>& positions, std::size_t begin, std::size_t end,
                         Ownership owned);
  void report();

  TetMesh& mesh_;
  PointRecord* records_;
  VertexIndex n_points_;
  Space3 space_;
  double cluster_distance_;
  const RunContext& context_;
  unsigned threads_;
  CavityInsertion<Space3> sequential_;
  std::vector<Twin> twins_;
  std::vector<VertexIndex> waiting_;
  std::size_t n_done_ = 0;
  DelaunayStatistics statistics_;
};

}  // namespace geomesh
