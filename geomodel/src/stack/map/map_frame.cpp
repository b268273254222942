// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/map/map_frame.hpp"

#include <cmath>

namespace geomesh::geomodel {

MapFrame::MapFrame(const std::vector<Vec2>& outline, bool is_box) {
  if (is_box) return;
  double longest = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &p = outline[i], &q = outline[(i + 1) % outline.size()];
    const double length = std::hypot(q.x - p.x, q.y - p.y);
    if (!(length > longest)) continue;
    longest = length;
    axis_ = {(q.x - p.x) / length, (q.y - p.y) / length};
  }
  origin_ = outline.front();
  is_turned_ = true;
}

Vec2 MapFrame::to_frame(const Vec2& p) const {
  if (!is_turned_) return p;
  const double x = p.x - origin_.x, y = p.y - origin_.y;
  return {axis_.x * x + axis_.y * y, axis_.x * y - axis_.y * x};
}

Vec2 MapFrame::to_model(const Vec2& p) const {
  if (!is_turned_) return p;
  return {origin_.x + axis_.x * p.x - axis_.y * p.y, origin_.y + axis_.y * p.x + axis_.x * p.y};
}

TriangulatedSurface MapFrame::to_frame(const TriangulatedSurface& surface) const {
  TriangulatedSurface turned = surface;
  for (Vec3& p : turned.points) {
    const Vec2 q = to_frame(Vec2{p.x, p.y});
    p.x = q.x;
    p.y = q.y;
  }
  return turned;
}

MapBounds MapFrame::bounds(const std::vector<Vec2>& outline) const {
  MapBounds b;
  for (const Vec2& p : outline) b.add(to_frame(p));
  return b;
}

}  // namespace geomesh::geomodel
