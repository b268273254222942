// SPDX-License-Identifier: MIT
/// @file
/// The faces of the Voronoi dual of a mesh: one for each edge.
#pragma once

#include <span>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh {

struct DualFace {
  VertexIndex a, b;  ///< the edge, a < b
  double area;       ///< with sign; see voronoi_dual.hpp
  bool on_border;    ///< of the mesh
};

/// In the order of the edges. The volume of the dual cell of a vertex is the sum of area times length over six of its
/// edges; all of them together are the volume of the mesh. Tetrahedra positive. O(n log n).
std::vector<DualFace> dual_faces(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra);

}  // namespace geomesh
