// SPDX-License-Identifier: MIT
/// @file
/// The constraints that meet in an added point (its segment and the facets around it), triangulated without the point.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "recover/model/recover.hpp"

namespace geomesh::recover {

/// The subfacets of one facet at an added point x, from one half of its segment to the other or all around x; or a
/// sheet, which is a triangle that divides the star of x.
struct Fan {
  Index facet = no_index;  ///< the facet of the subfacets; no_index for an added triangle that divides the star of x
  std::vector<VertexIndex>
      /// vertices opposite x in the facet's triangles at x, in the facet's order; a closed ring if x is inside it
      rim;
  bool is_closed = false;
  std::vector<Index> subfacets;
  std::vector<Triangle> triangles;  ///< triangles without x that replace the facet's subfacets at x when x is removed
  /// Returns whether the facet's only triangle at x has no width up to rounding, so that nothing needs to replace it.
  bool is_thin() const { return rim.size() < 3; }
};

struct StarFans {
  std::vector<Index> halves;      ///< the two subsegments at the added point x, or none if x is on no segment
  std::vector<VertexIndex> ends;  ///< what they join
  std::vector<Fan> fans;

  bool is_end(VertexIndex v) const { return std::find(ends.begin(), ends.end(), v) != ends.end(); }
};

/// Finds the segment and the facets' triangles at x, and triangulates the facets without x. Returns nothing if x cannot
/// be removed: more than one segment ends there, or a facet has no such triangulation in its main projection.
std::optional<StarFans> find_star_fans(Recovery& recovery, VertexIndex x, const std::vector<CellIndex>& star);

/// Returns the sum of the normals of a facet's triangles at x, each as long as twice the triangle's area.
Vec3 fan_normal(const ConstrainedMesh& mesh, VertexIndex x, const Fan& fan);

}  // namespace geomesh::recover
