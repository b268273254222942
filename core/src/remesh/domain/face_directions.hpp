// SPDX-License-Identifier: MIT
/// @file
/// Normal directions of the faces of surfaces, including faces without area.
#pragma once

#include <span>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::remesh {

/// Incidence of an edge and a constrained face.
struct EdgeUse {
  std::array<VertexIndex, 2> edge;  ///< ascending
  Index face;
};

/// Returns whether the face runs along its edge from a to b (and not from b to a).
bool runs_along(const Triangle& t, VertexIndex a, VertexIndex b);

/// Returns the unit normal of each face. A face whose height is below `narrow` would vanish if one point moved by less
/// than that, so its own normal means nothing; crossings near the side of a triangle leave such faces. It gets the
/// normal of the face on the other side of its longest edge, if the edge has exactly these two faces and both are of
/// one patch. The normal is zero if none is found within a few steps.
///
/// Precondition: `uses` is in ascending order of edges, with three entries for each face. O(n).
std::vector<Vec3> face_directions(const std::vector<Vec3>& points, std::span<const Triangle> faces,
                                  std::span<const Index> patch_of_face, std::span<const EdgeUse> uses, double narrow);

}  // namespace geomesh::remesh
