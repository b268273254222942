// SPDX-License-Identifier: MIT
/// @file
/// The Voronoi dual of a mesh as finite volumes use it: an area for each edge.
#pragma once

#include <cstddef>
#include <span>

#include "geomesh/core/geometry.hpp"

namespace geomesh {

struct VoronoiDual {
  std::size_t edges = 0;
  std::size_t negative = 0;            ///< edges whose dual area is below zero by more than rounding
  std::size_t negative_on_border = 0;  ///< of these, edges of the mesh's boundary
  double least = 0;                    ///< the least dual area over the square of its edge's length; 0 for no edges
};

/// The dual area of an edge is that of the polygon through the circumcentres of the tetrahedra about it, with sign. It
/// goes from face circumcentre to face circumcentre; on the boundary it ends in the faces. It is not negative inside a
/// Delaunay mesh; at the boundary it is not where circumcentres do not lie beyond it. In doubles: "negative" is below
/// -1e-12 of the squared length of the edge. Tetrahedra positive. O(n log n).
VoronoiDual measure_voronoi_dual(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra);

}  // namespace geomesh
