// SPDX-License-Identifier: GPL-3.0-or-later
// Makes horizons from their thickness below another horizon, declared in geomesh/geomodel/section.hpp.
#include <algorithm>
#include <cmath>

#include "geomesh/geomodel/section.hpp"
#include "rules/planar/map_locator.hpp"

namespace geomesh::geomodel {
namespace {

/// Returns the thickness at the point p of the map. At the rim of the thickness surface, points that rounding has moved
/// just outside are accepted too.
std::optional<double> thickness_at(const MapLocator& thickness, const Vec2& p, double rounding) {
  if (const auto found = thickness.height(p)) return found;
  for (const double dx : {-rounding, 0.0, rounding})
    for (const double dy : {-rounding, 0.0, rounding})
      if (const auto found = thickness.height({p.x + dx, p.y + dy})) return found;
  return std::nullopt;
}

}  // namespace

BelowSurface surface_below(const TriangulatedSurface& above, const TriangulatedSurface& thickness) {
  const MapLocator locator(thickness);
  Box3 bounds;
  for (const Vec3& p : thickness.points) bounds.add(p);
  const double rounding = 1e-9 * std::max({bounds.max.x - bounds.min.x, bounds.max.y - bounds.min.y, 1.0});
  BelowSurface below;
  below.surface = above;
  bool is_first = true;
  for (Vec3& p : below.surface.points) {
    const auto found = thickness_at(locator, {p.x, p.y}, rounding);
    if (!found) {
      ++below.n_without;
      p.z = std::nan("");
      continue;
    }
    below.n_negative += *found < 0;
    const double taken = std::max(*found, 0.0);
    below.least = is_first ? taken : std::min(below.least, taken);
    below.most = is_first ? taken : std::max(below.most, taken);
    is_first = false;
    p.z -= taken;
  }
  if (below.n_without == 0) return below;
  TriangulatedSurface& s = below.surface;
  std::erase_if(s.triangles, [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](VertexIndex v) { return std::isnan(s.points[v].z); });
  });
  std::vector<VertexIndex> row(s.points.size(), no_vertex);
  std::vector<Vec3> kept;
  for (Triangle& t : s.triangles)
    for (VertexIndex& v : t) {
      if (row[v] == no_vertex) {
        row[v] = static_cast<VertexIndex>(kept.size());
        kept.push_back(s.points[v]);
      }
      v = row[v];
    }
  s.points = std::move(kept);
  return below;
}

BelowSurface surface_below(const TriangulatedSurface& above, double thickness) {
  BelowSurface below;
  below.surface = above;
  below.least = below.most = thickness;
  for (Vec3& p : below.surface.points) p.z -= thickness;
  return below;
}

}  // namespace geomesh::geomodel
