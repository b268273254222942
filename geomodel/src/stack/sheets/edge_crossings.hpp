// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds where edges of the input data cross edges of the ordered horizons in the map. The vertical distance between
/// both is linear between these crossings and the vertices of both.
#pragma once

#include <algorithm>
#include <cmath>

#include "stack/map/growing_triangulation.hpp"
#include "stack/map/map_samples.hpp"

namespace geomesh::geomodel {

/// The crossing of an edge of a horizon's data with a side of a triangle of the map.
struct EdgeCrossing {
  std::size_t horizon;
  Index cell;          ///< triangle of the map that the data's edge leaves at this crossing
  VertexIndex a, b;    ///< the side
  double along;        ///< position of the crossing on the triangle's side, from 0 at a to 1 at b
  double from_vertex;  ///< distance in m of the crossing from the nearer end of the triangle's side
  Vec2 place;
  double height;  ///< of the data
};

/// Calls f with each crossing of an edge of a horizon's data with a side of a triangle of the map, horizon by horizon.
/// Cost: linear in the data and the crossings.
template <class F>
void for_each_crossing(const GrowingTriangulation& map, const MapSamples& samples, F&& f) {
  for (std::size_t k = 0; k < samples.n_surfaces(); ++k) {
    const TriangulatedSurface& s = samples.surface(k);
    Index near = 0;
    for (const Triangle& t : s.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 *p = &s.points[t[i]], *q = &s.points[t[(i + 1) % 3]];
        if (t[i] > t[(i + 1) % 3]) continue;
        Index start = map.locate({p->x, p->y}, near);
        if (start == no_index) std::swap(p, q), start = map.locate({p->x, p->y}, near);
        if (start == no_index) continue;
        near = start;
        const Vec2 from{p->x, p->y};
        map.walk(from, start, {q->x, q->y}, [&](Index cell, VertexIndex a, VertexIndex b, double t) {
          const Vec2 x{from.x + t * (q->x - from.x), from.y + t * (q->y - from.y)};
          const Vec2 &pa = map.points()[a], &pb = map.points()[b];
          const double dx = pb.x - pa.x, dy = pb.y - pa.y;
          const double along = ((x.x - pa.x) * dx + (x.y - pa.y) * dy) / (dx * dx + dy * dy);
          f(EdgeCrossing{k, cell, a, b, along, std::min(along, 1 - along) * std::hypot(dx, dy), x,
                         p->z + t * (q->z - p->z)});
        });
      }
  }
}

}  // namespace geomesh::geomodel
