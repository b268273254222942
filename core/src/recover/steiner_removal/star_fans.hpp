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
  Index facet = no_index;  ///< no_index for a sheet
  std::vector<VertexIndex>
      /// vertices opposite x in the facet's orientation; the last is connected with the first if the fan is closed
      rim;
  bool is_closed = false;
  std::vector<Index> subfacets;
  std::vector<Triangle> triangles;  ///< triangles that replace the subfacets
  /// A part of zero width between the segment and its chord, which rounding has left beside x; nothing replaces it.
  bool is_thin() const { return rim.size() < 3; }
};

struct StarFans {
  std::vector<Index> halves;      ///< the two subsegments at x, or none
  std::vector<VertexIndex> ends;  ///< what they join
  std::vector<Fan> fans;

  bool is_end(VertexIndex v) const { return std::find(ends.begin(), ends.end(), v) != ends.end(); }
};

/// Finds the constraints at x. Returns nothing if x cannot be removed: more than one segment ends there, or a fan has
/// no triangulation in the facet's main projection.
std::optional<StarFans> find_star_fans(Recovery& recovery, VertexIndex x, const std::vector<CellIndex>& star);

/// Returns twice the area vector of the fan around x.
Vec3 fan_normal(const ConstrainedMesh& mesh, VertexIndex x, const Fan& fan);

}  // namespace geomesh::recover
