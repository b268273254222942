// SPDX-License-Identifier: MIT
/// @file
/// The cavity algorithm over all points: rounds in spatial order, large ones in parts side by side, clustered points
/// last.
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
/// tetrahedra"). A part is a stretch of the Hilbert curve. It may only change cells all of whose vertices lie on its
/// stretch. A point that needs more waits. Other than there, the parts depend on the number of points alone and take
/// their slots from stripes of their own. So every part does the same work whatever the threads, and the result is the
/// same in every byte. No locks are needed.
///
/// Why no two parts meet: a cell that a part removes has all its vertices in it. Such a cell shares three vertices with
/// each neighbour. So a neighbour that is not the part's own has at least two finite vertices in this part. It is no
/// other part's own either: its vertices stay as they are. Each of its neighbour links is written by one part at most.
class CavityStage {
 public:
  CavityStage(TetMesh& mesh, PointRecord* records, VertexIndex n_points, double unit, double cluster_distance,
              const RunContext& context);

  void start(const Tetrahedron& first) { sequential_.start(first); }
  /// Positions [begin, end), which lie along the curve.
  void insert_round(VertexIndex begin, VertexIndex end);
  /// The points that were too near to others. The triangulation is then complete.
  void insert_waiting();
  /// Drops unused slots. Adds to the statistics.
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
