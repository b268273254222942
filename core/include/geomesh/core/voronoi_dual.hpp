// SPDX-License-Identifier: MIT
/// @file
/// The Voronoi dual of a mesh for finite volumes: an area for each edge.
#pragma once

#include <cstddef>
#include <span>

#include "geomesh/core/geometry.hpp"

namespace geomesh {

struct VoronoiDual {
  std::size_t edges = 0;
  std::size_t negative = 0;            ///< number of edges whose dual area is below zero by more than rounding
  std::size_t negative_on_border = 0;  ///< number of edges on the boundary with a negative dual area
  double least = 0;  ///< least dual area divided by the squared length of its edge; 0 if there are no edges
};

/// Measures the dual areas of a mesh. The dual area of an edge is the signed area of the polygon through the
/// circumcentres of the tetrahedra around it, passing through the circumcentres of the faces; on the boundary the
/// polygon ends in the faces. The area is not negative inside a Delaunay mesh, nor at the boundary if no circumcentre
/// lies beyond the boundary. Areas are computed in doubles: "negative" means below -1e-12 of the squared length of the
/// edge. Tetrahedra must be positive. O(n log n).
VoronoiDual measure_voronoi_dual(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra);

}  // namespace geomesh
