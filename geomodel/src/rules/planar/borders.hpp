// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Borders of a surface as read, and the frame in which a surface is continued.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// An edge of one triangle alone (equal coordinates merged), in the direction in which its triangle runs through it.
struct BorderEdge {
  VertexIndex a, b;  ///< the first rows with these coordinates
  Index triangle;
};

/// In the order of triangles.
std::vector<BorderEdge> border_edges(const TriangulatedSurface& surface);

/// The border's closed loops, each in the direction of its edges; edges that do not close up (two loops through one
/// point are parted there) are left out and counted.
struct BorderLoops {
  std::vector<std::vector<VertexIndex>> loops;
  std::size_t n_edges_left = 0;
};
BorderLoops border_loops(const std::vector<BorderEdge>& edges);

/// An orthonormal frame: map (u = x, v = y, w = z) or the mean plane of a surface or loop.
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
/// Frame whose w is the direction of `normal`; the map where normal is zero.
Frame frame_of_normal(const Vec3& origin, const Vec3& normal);

/// The map for horizons; the mean plane for faults and bodies. Expects at least one triangle.
Frame frame_of(const TriangulatedSurface& surface);

/// Whether most of the area, as the triangles are given, faces up in the frame: triangles that are added are stored
/// alike.
bool faces_up(const TriangulatedSurface& surface, const Frame& frame);

/// Area of the triangles from row `first` on.
double area_from(const TriangulatedSurface& surface, std::size_t first);

}  // namespace geomesh::geomodel
