// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The borders of a surface before the arrangement, and the frame in which the surface is extended.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// An edge with only one triangle (points with equal coordinates are merged), in the direction of that triangle.
struct BorderEdge {
  VertexIndex a, b;  ///< the edge's ends; of points with equal coordinates, the first in the surface
  Index triangle;
};

/// Returns the border edges in the order of their triangles.
std::vector<BorderEdge> border_edges(const TriangulatedSurface& surface);

/// The closed loops of a border, each in the direction of its edges; two loops through one point are separated. Edges
/// that do not close a loop are left out and counted.
struct BorderLoops {
  std::vector<std::vector<VertexIndex>> loops;
  std::size_t n_edges_left = 0;
};
BorderLoops border_loops(const std::vector<BorderEdge>& edges);

/// An orthonormal frame: the map (u = x, v = y, w = z) or the mean plane of a surface or loop.
struct Frame {
  Vec3 origin, u{1, 0, 0}, v{0, 1, 0}, w{0, 0, 1};
  bool is_map = true;
  Vec3 to_frame(const Vec3& p) const {
    if (is_map) return p;
    const Vec3 d = p - origin;
    return {dot(d, u), dot(d, v), dot(d, w)};
  }
  Vec3 to_model(const Vec3& q) const {
    if (is_map) return q;
    return origin + q.x * u + q.y * v + q.z * w;
  }
};
/// Returns a frame whose axis w has the direction of `normal`; the map if the normal is zero.
Frame frame_of_normal(const Vec3& origin, const Vec3& normal);

/// Returns the frame in which a surface (not empty) is extended: the map for horizons, the mean plane for others.
Frame frame_of(const TriangulatedSurface& surface);

/// Returns whether most of the surface's area faces up in the frame, so that added triangles get the same orientation.
bool faces_up(const TriangulatedSurface& surface, const Frame& frame);

/// Returns the area of the surface's triangles from index `first` on.
double area_from(const TriangulatedSurface& surface, std::size_t first);

}  // namespace geomesh::geomodel
