// SPDX-License-Identifier: MIT
/// @file
/// The faces of the Voronoi dual of a mesh: one for each edge.
#pragma once

#include <functional>
#include <span>

#include "geomesh/core/geometry.hpp"

namespace geomesh {

struct DualFace {
  VertexIndex a, b;  ///< ends of the edge, a < b
  double area;       ///< signed area of the dual face; see voronoi_dual.hpp
};

/// Calls `use` with each face of the Voronoi dual, in the order of the mesh edges. The volume of the dual cell of a
/// vertex is a sixth of the sum of area times length over the edges at this vertex; the sum of these volumes over all
/// vertices is the volume of the mesh. Tetrahedra must be positive. O(n log n); uses about six bytes per tetrahedron.
void for_each_dual_face(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra,
                        const std::function<void(const DualFace&)>& use);

}  // namespace geomesh
