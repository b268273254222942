// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Parts of a surface that provably do not cross themselves, so that the broad phase need not look at pairs inside
/// them.
///
/// Most pairs of triangles whose boxes meet are neighbours in one surface. A chart is a set of facets, joined across
/// edges, each taken in the orientation in which it is counter-clockwise in projection along one axis. Take a point of
/// the plane that lies on no edge. The number of facets of a chart over it is the winding number of its border about
/// the point. Let the border's edges meet only in shared ends and the winding number never exceed one. Then the
/// projected facets of the chart are disjoint except for shared corners and edges, and therefore so are the facets
/// themselves. (The idea of culling self-collisions by normals and contours is Volino and Magnenat-Thalmann's, 1994;
/// here every sign is exact.)
#pragma once

#include <vector>

#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

/// Returns the chart of each facet, or no_index. Two facets of one chart meet only in shared vertices and edges. The
/// same whatever the number of threads; linear time, plus n log n for the borders.
std::vector<Index> find_charts(const Complex& complex);

/// An edge of a chart's border, with the chart on its left.
struct BorderEdge {
  VertexIndex from, to;
};
/// Returns whether the border, projected along `axis`, meets itself only in shared vertices and no point has a winding
/// number above one. Border edges leave each vertex as often as they reach it.
bool winds_at_most_once(const std::vector<Vec3>& points, std::size_t axis, const std::vector<BorderEdge>& border);

}  // namespace geomesh::geomodel::arrangement
