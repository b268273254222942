// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/planar/map_locator.hpp"

#include <algorithm>
#include <cmath>

namespace geomesh::geomodel {
namespace {

Vec2 map(const Vec3& p) { return {p.x, p.y}; }

}  // namespace

MapLocator::MapLocator(const TriangulatedSurface& surface) : surface_(surface) {
  for (const Triangle& t : surface.triangles)
    for (VertexIndex v : t) bounds_.add(surface.points[v]);
  n_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(static_cast<double>(surface.triangles.size()))));
  cells_.resize(n_ * n_);
  for (Index t = 0; t < surface.triangles.size(); ++t) {
    Box3 box;
    for (VertexIndex v : surface.triangles[t]) box.add(surface.points[v]);
    const std::size_t i0 = cell_of(box.min.x, bounds_.min.x, bounds_.max.x),
                      i1 = cell_of(box.max.x, bounds_.min.x, bounds_.max.x);
    const std::size_t j0 = cell_of(box.min.y, bounds_.min.y, bounds_.max.y),
                      j1 = cell_of(box.max.y, bounds_.min.y, bounds_.max.y);
    for (std::size_t j = j0; j <= j1; ++j)
      for (std::size_t i = i0; i <= i1; ++i) cells_[j * n_ + i].push_back(t);
  }
}

std::size_t MapLocator::cell_of(double x, double min, double max) const {
  if (!(max > min)) return 0;
  const double at = (x - min) / (max - min) * static_cast<double>(n_);
  return std::min(n_ - 1, static_cast<std::size_t>(std::max(0.0, at)));
}

void MapLocator::for_each(Vec2 p, const std::function<void(Index, bool)>& found) const {
  if (!(p.x >= bounds_.min.x && p.x <= bounds_.max.x && p.y >= bounds_.min.y && p.y <= bounds_.max.y)) return;
  for (const Index t :
       cells_[cell_of(p.y, bounds_.min.y, bounds_.max.y) * n_ + cell_of(p.x, bounds_.min.x, bounds_.max.x)]) {
    const Triangle& v = surface_.triangles[t];
    const Vec2 a = map(surface_.points[v[0]]), b = map(surface_.points[v[1]]), c = map(surface_.points[v[2]]);
    const Sign turn = orient2d(a, b, c);
    if (turn == Sign::zero) continue;
    const Sign s0 = orient2d(a, b, p) * turn, s1 = orient2d(b, c, p) * turn, s2 = orient2d(c, a, p) * turn;
    if (s0 == Sign::negative || s1 == Sign::negative || s2 == Sign::negative) continue;
    found(t, s0 == Sign::positive && s1 == Sign::positive && s2 == Sign::positive);
  }
}

MapLocator::Hit MapLocator::find(Vec2 p) const {
  Hit hit;
  for_each(p, [&](Index t, bool strictly) {
    if (hit.count++ == 0) hit.triangle = t;
    hit.strictly = strictly;
  });
  return hit;
}

double MapLocator::height(Index triangle, Vec2 p) const {
  const Triangle& v = surface_.triangles[triangle];
  for (VertexIndex row : v)
    if (surface_.points[row].x == p.x && surface_.points[row].y == p.y) return surface_.points[row].z;
  const Vec3 &a = surface_.points[v[0]], &b = surface_.points[v[1]], &c = surface_.points[v[2]];
  const double ux = b.x - a.x, uy = b.y - a.y, wx = c.x - a.x, wy = c.y - a.y, px = p.x - a.x, py = p.y - a.y;
  const double det = ux * wy - uy * wx;
  return a.z + (px * wy - py * wx) / det * (b.z - a.z) + (ux * py - uy * px) / det * (c.z - a.z);
}

std::optional<double> MapLocator::height(Vec2 p) const {
  const Hit hit = find(p);
  if (hit.count == 0) return std::nullopt;
  return height(hit.triangle, p);
}

}  // namespace geomesh::geomodel
