// SPDX-License-Identifier: MIT
/// @file
/// Triangulation of one polygonal facet with holes, inner segments and inner points: the draft of Cavalcanti and Mello
/// 1999 (section 3.2). It is a constrained Delaunay triangulation in the facet's plane, with ties broken as in 3D.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh {

/// A polygonal facet. Its vertices are indices of points.
struct FacetPolygon {
  std::vector<std::vector<VertexIndex>> loops;  ///< outer, holes
  std::vector<std::array<VertexIndex, 2>> segments;
  std::vector<VertexIndex> inner_points;
};

struct FacetTriangulation {
  std::vector<Triangle> triangles;  ///< triangles with the orientation of the facet's outer loop
  bool exactly_planar = false;
  double deviation = 0;  ///< largest distance of a facet vertex from the mean plane; zero if exactly planar
};

/// Why a polygon cannot be used, with the vertices that cause it.
struct FacetFault {
  std::string message;
  std::vector<VertexIndex> vertices;
};

/// Returns the constrained Delaunay triangulation of a polygon. Returns nothing if the polygon is invalid (zero area, a
/// loop that crosses itself, a vertex on an edge ...); `fault` then has the reason. O(n log n) plus flips.
std::optional<FacetTriangulation> triangulate_facet(std::span<const Vec3> points, const FacetPolygon& polygon,
                                                    FacetFault& fault);

}  // namespace geomesh
