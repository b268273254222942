// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds where the vertical line through a point crosses a triangulated surface.
#pragma once

#include <functional>

#include "check/exact/box_tree.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel::checking {

BoxTree tree_over_triangles(const TriangulatedSurface& surface);

/// Calls visit(triangle, z) for every triangle of the surface that the vertical line through p crosses, or passes at a
/// horizontal distance of less than `room`. Crossings are decided exactly; heights are rounded.
void for_each_height(const TriangulatedSurface& surface, const BoxTree& tree, const Vec3& p, double room,
                     const std::function<void(Index, double)>& visit);

}  // namespace geomesh::geomodel::checking
