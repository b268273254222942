// SPDX-License-Identifier: MIT
/// @file
/// Recovery in stages, hard parts first, for models for which an attempt at recovery has failed. Long thin facets side
/// by side, an ulp off one plane, are recovered without points in a mesh that contains hardly more than their own
/// vertices, but rarely if the vertices of everything else lie between them. Items that flips and cavities could not
/// recover are therefore counted. The vertices of the items with the highest counts are triangulated first, and their
/// facets are recovered before other vertices are inserted (own design; the counts follow conflict-driven
/// satisfiability solvers).
#pragma once

#include <vector>

#include "geomesh/core/delaunay.hpp"
#include "recover/model/declare.hpp"
#include "recover/model/recover.hpp"

namespace geomesh::recover {

class HardPartsFirst {
 public:
  /// Must be called after a failed attempt. Later attempts insert earlier the vertices of facets that flips and
  /// cavities did not recover, and of the facets around such segments: by one stage for each call. O(facets).
  void learn(const Recovery& recovery, const DeclaredModel& model);
  bool has_learned() const { return !stage_.empty(); }

  /// Returns the Delaunay triangulation of the vertices that are inserted first and the eight vertices of the box.
  /// `points` has all vertices of the model, followed by those of the box; the mesh has the same numbering.
  TetMesh triangulate(const std::vector<Vec3>& points, const DelaunayOptions& options, const RunContext& context) const;

  /// Starts from the mesh of triangulate(). Recovers the items that have all their vertices in the mesh, inserts the
  /// vertices of the next stage, and so on until all vertices are in the mesh. Items with vertices of the last stage
  /// are left to the caller. Ends the attempt as recover_segments and recover_facets do, and if rounding has put an
  /// added point in the way of a vertex.
  void run(Recovery& recovery) const;

 private:
  std::uint8_t first_stage() const;

  std::vector<std::uint8_t>
      stage_;  ///< how often each vertex was on an item that is hard to recover; the highest numbers are inserted first
};

}  // namespace geomesh::recover
