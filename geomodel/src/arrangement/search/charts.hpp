// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds charts: parts of a surface that provably do not cross themselves, so that the broad phase need not look at
/// pairs inside them. Most pairs of triangles whose boxes meet are neighbours in one surface. A chart is a set of
/// facets, connected across edges, each oriented counter-clockwise in projection along one axis. Consider a point of
/// the projection plane that lies on no edge. The number of facets of the chart over it is the winding number of the
/// chart's border about the point. Suppose that the border's edges meet only in shared ends and that no winding number
/// exceeds one. Then the projected facets of the chart are disjoint except for shared corners and edges, and therefore
/// so are the facets themselves. (The idea of culling self-collisions by normals and contours is from Volino and
/// Magnenat-Thalmann, 1994; here every sign is exact.)
#pragma once

#include <vector>

#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

/// Returns the chart of each facet, or no_index. Two facets of one chart meet only in shared vertices and edges. The
/// result is the same whatever the number of threads. Linear time, plus n log n for the borders.
std::vector<Index> find_charts(const Complex& complex);

/// An edge of a chart's border, with the chart on its left.
struct BorderEdge {
  VertexIndex from, to;
};
/// Returns whether a chart's border, projected along `axis`, meets itself only in shared vertices and no point has a
/// winding number above one. Precondition: as many border edges leave each vertex as reach it.
bool winds_at_most_once(const std::vector<Vec3>& points, std::size_t axis, const std::vector<BorderEdge>& border);

}  // namespace geomesh::geomodel::arrangement
