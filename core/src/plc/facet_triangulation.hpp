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
  double deviation = 0;  ///< largest distance of a vertex from the mean plane; zero where exactly planar
};

/// What makes a polygon unusable; the vertices are those to blame.
struct FacetFault {
  std::string message;
  std::vector<VertexIndex> vertices;
};

/// O(n log n) plus flips. Without a value: `fault` says why (zero area, loop crosses itself, vertex on an edge ...).
std::optional<FacetTriangulation> triangulate_facet(std::span<const Vec3> points, const FacetPolygon& polygon,
                                                    FacetFault& fault);

}  // namespace geomesh
