// SPDX-License-Identifier: MIT
/// @file
/// Measures how far patches of coplanar triangles are from Delaunay, and so the cost of recovering their inner edges.
#pragma once

#include <span>
#include <vector>

#include "common/geometry.hpp"

namespace geomesh {

/// An edge between two coplanar triangles.
struct InnerEdge {
  VertexIndex a, b;              ///< a < b
  VertexIndex apex, other_apex;  ///< third vertices of the two triangles that share the edge
};

/// Largest number of edges of a triangulation of n points that a segment between two of them can cross. Each crossed
/// edge connects a vertex on the left of the segment with one on its right, and such a bipartite planar graph with m >=
/// 3 vertices has at most 2 m - 4 edges.
constexpr std::size_t most_crossed(std::size_t n) { return n < 4 ? 0 : n == 4 ? 1 : 2 * (n - 2) - 4; }

/// Returns whether the inner edges of plane patches cross more than `most` edges each, on average over all patches, of
/// the Delaunay triangulations of the patches' vertices. Patch k has the edges first[k] .. first[k + 1] - 1, in
/// increasing order of (a, b) with a < b; each of its triangles has at least one. Patches are not triangulated if one
/// flip of each non-Delaunay edge suffices, or if the remaining patches cannot change the result. O(n log n).
bool are_far_from_delaunay(std::span<const Vec3> points, std::span<const InnerEdge> edges, std::span<const Index> first,
                           double most);

}  // namespace geomesh
