// SPDX-License-Identifier: MIT
/// @file
/// Recovery in stages, hard parts first, for models of which an attempt has failed. Long thin facets side by side, an
/// ulp off one plane, are recovered without points in a mesh of little but their own vertices. They hardly ever are
/// where the vertices of all else stand between them. So what flips and cavities could not recover counts. The
/// vertices of what has counted most often are triangulated and their facets recovered before the next ones are
/// inserted (own design; the counting is after the conflict-driven order of satisfiability solvers).
#pragma once

#include <vector>

#include "geomesh/core/delaunay.hpp"
#include "recover/model/declare.hpp"
#include "recover/model/recover.hpp"

namespace geomesh::recover {

class HardPartsFirst {
 public:
  /// After a failed attempt: the vertices of the facets that flips and cavities did not recover, and of those about
  /// such segments, come one stage earlier from now on. O(facets).
  void learn(const Recovery& recovery, const DeclaredModel& model);
  bool has_learned() const { return !stage_.empty(); }

  /// The Delaunay triangulation of the first stage's vertices and the eight of the box, in the numbers of `points`: all
  /// of the model's, then the box's.
  TetMesh triangulate(const std::vector<Vec3>& points, const DelaunayOptions& options, const RunContext& context) const;

  /// From that mesh: recovers what has all its vertices, inserts those of the next stage beside what is recovered, and
  /// so on until all are in the mesh. What the last stage's vertices bring is left to recover. The
  /// attempt ends as in recover_segments and recover_facets, and where rounding has put an added point in a vertex'
  /// way.
  void run(Recovery& recovery) const;

 private:
  std::uint8_t first_stage() const;

  std::vector<std::uint8_t>
      stage_;  ///< of each vertex: how often it has been part of what was hard; the highest comes first
};

}  // namespace geomesh::recover
