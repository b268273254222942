// SPDX-License-Identifier: MIT
/// @file
/// Triangulation of one polygonal facet (holes, inner segments, inner points): the paper's draft (section 3.2). A
/// constrained Delaunay triangulation in the facet's plane, ties broken as in 3D.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh {

/// Vertices are rows of `points`.
struct FacetPolygon {
  std::vector<std::vector<VertexIndex>> loops;  ///< outer, holes
  std::vector<std::array<VertexIndex, 2>> segments;
  std::vector<VertexIndex> inner_points;
};

struct FacetTriangulation {
  std::vector<Triangle> triangles;  ///< in the orientation of the outer loop
  bool exactly_planar = false;
  double deviation = 0;  ///< largest distance of a vertex from the mean plane; zero if exactly planar
};

/// Why a polygon cannot be used, with the vertices that cause it.
struct FacetFault {
  std::string message;
  std::vector<VertexIndex> vertices;
};

/// O(n log n) plus flips. Returns nothing for a polygon that cannot be used; then `fault` has the reason (zero area, a
/// loop that crosses itself, a vertex on an edge ...).
std::optional<FacetTriangulation> triangulate_facet(std::span<const Vec3> points, const FacetPolygon& polygon,
                                                    FacetFault& fault);

}  // namespace geomesh
