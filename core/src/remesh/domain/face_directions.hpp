// SPDX-License-Identifier: MIT
/// @file
/// Normal directions of the faces of surfaces, including faces without area.
#pragma once

#include <span>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::remesh {

/// A constrained face at one of its edges.
struct EdgeUse {
  std::array<VertexIndex, 2> edge;  ///< ascending
  Index face;
};

/// Returns whether the face passes the edge from a to b, and not from b to a.
bool runs_along(const Triangle& t, VertexIndex a, VertexIndex b);

/// Returns unit normals by face. A face lower than `narrow` could be removed by moving a point by less than that, so
/// its own normal means nothing, as where a crossing met the side of a triangle. It takes the normal of the face beyond
/// its longest edge. That edge must have one other face, and both must be of one patch; the normal is zero if none is
/// found within a few steps.
///
/// Preconditions: `uses` in ascending order of edges, three for each face. O(n).
std::vector<Vec3> face_directions(const std::vector<Vec3>& points, std::span<const Triangle> faces,
                                  std::span<const Index> patch_of_face, std::span<const EdgeUse> uses, double narrow);

}  // namespace geomesh::remesh
