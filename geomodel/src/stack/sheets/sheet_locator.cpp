// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/sheets/sheet_locator.hpp"

namespace geomesh::geomodel {
namespace {

TriangulatedSurface flat(const MapSheets& sheets) {
  TriangulatedSurface s;
  for (const Vec2& p : sheets.points) s.points.push_back({p.x, p.y, 0});
  s.triangles = sheets.triangles;
  return s;
}

std::array<double, 3> weights(const MapSheets& sheets, Index triangle, const Vec2& p) {
  const Triangle& t = sheets.triangles[triangle];
  const Vec2 &a = sheets.points[t[0]], &b = sheets.points[t[1]], &c = sheets.points[t[2]];
  const double ux = b.x - a.x, uy = b.y - a.y, wx = c.x - a.x, wy = c.y - a.y, px = p.x - a.x, py = p.y - a.y;
  const double det = ux * wy - uy * wx, wb = (px * wy - py * wx) / det, wc = (ux * py - uy * px) / det;
  return {1 - wb - wc, wb, wc};
}

}  // namespace

SheetLocator::SheetLocator(const MapSheets& sheets) : sheets_(sheets), surface_(flat(sheets)), locator_(surface_) {}

SheetLocator::Place SheetLocator::find(const Vec2& p) const {
  Place at;
  at.triangle = locator_.find(p).triangle;
  if (at.triangle != no_index) at.weights = weights(sheets_, at.triangle, p);
  return at;
}

double SheetLocator::height(const Place& at, std::size_t horizon) const {
  const Triangle& t = sheets_.triangles[at.triangle];
  return at.weights[0] * sheets_.height(t[0], horizon) + at.weights[1] * sheets_.height(t[1], horizon) +
         at.weights[2] * sheets_.height(t[2], horizon);
}

}  // namespace geomesh::geomodel
