// SPDX-License-Identifier: MIT
/// @file
/// Recovery in stages, hard parts first, for models of which an attempt has failed. Long thin facets side by side, an
/// ulp off one plane, are recovered without points in a mesh that contains hardly more than their own vertices, but
/// rarely if the vertices of everything else lie between them. Items that flips and cavities could not recover are
/// therefore counted. The vertices of what has counted most often are triangulated and their facets recovered before
/// the next ones are inserted (own design; the counting is after the conflict-driven order of satisfiability solvers).
#pragma once

#include <vector>

#include "geomesh/core/delaunay.hpp"
#include "recover/model/declare.hpp"
#include "recover/model/recover.hpp"

namespace geomesh::recover {

class HardPartsFirst {
 public:
  /// Called after a failed attempt: the vertices of the facets that flips and cavities did not recover, and of those
  /// around such segments, are inserted one stage earlier from now on. O(facets).
  void learn(const Recovery& recovery, const DeclaredModel& model);
  bool has_learned() const { return !stage_.empty(); }

  /// Returns the Delaunay triangulation of the first stage's vertices and the eight of the box, in the numbers of
  /// `points`: all of the model's, followed by the box's.
  TetMesh triangulate(const std::vector<Vec3>& points, const DelaunayOptions& options, const RunContext& context) const;

  /// Starting from that mesh, recovers items that have all their vertices, inserts those of the next stage beside what
  /// is recovered, and so on until all are in the mesh. Items of the last stage's vertices are left to recover. Ends
  /// the attempt as recover_segments and recover_facets do, and if rounding has put an added point in the way of a
  /// vertex.
  void run(Recovery& recovery) const;

 private:
  std::uint8_t first_stage() const;

  std::vector<std::uint8_t>
      stage_;  ///< for each vertex: how often it has been part of something hard; the highest come first
};

}  // namespace geomesh::recover
