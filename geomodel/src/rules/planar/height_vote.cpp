// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/planar/height_vote.hpp"

#include <algorithm>

#include "geomesh/core/predicates.hpp"

namespace geomesh::geomodel {
namespace {

Vec2 map(const Vec3& p) { return {p.x, p.y}; }

}  // namespace

HeightVote::Left::Left(const WorkingSoup& working, const std::function<bool(Index)>& is_mine) {
  surface_.points = working.soup.points;
  for (Index f = 0; f < working.soup.facets.size(); ++f)
    if (is_mine(f)) surface_.triangles.push_back(working.soup.facets[f]);
  if (!surface_.triangles.empty()) locator_.emplace(surface_);
}

HeightVote::HeightVote(const WorkingSoup& working, Index y, const std::vector<TriangulatedSurface>& surfaces)
    : working_(working), y_(working, [&](Index f) { return working.has(f, y); }), faults_(working, [&](Index f) {
        return std::ranges::any_of(working.origins[f], [&](const PolygonSoup::Origin& o) {
          return surfaces[o.surface].kind == SurfaceKind::fault;
        });
      }) {}

/// Returns whether a fault passes between the heights of two surfaces at a place. The end points do not count: heights
/// are rounded, and a fault that ends on a surface may be rounded exactly onto it.
bool HeightVote::is_fault_between(const Vec3& p, double height) const {
  if (!faults_.locator()) return false;
  bool is_between = false;
  faults_.locator()->for_each(map(p), [&](Index t, bool) {
    const double z = faults_.locator()->height(t, map(p));
    is_between = is_between || (z > std::min(p.z, height) && z < std::max(p.z, height));
  });
  return is_between;
}

int HeightVote::side_of(const Piece& piece) const {
  if (!y_.locator()) return 0;
  double above = 0, below = 0;
  for (const Index f : piece.facets) {
    const Vec3 p = working_.centre(f);
    const MapLocator::Hit hit = y_.locator()->find(map(p));
    if (hit.count != 1 || !hit.strictly) continue;
    const Triangle& t = y_.surface().triangles[hit.triangle];
    const std::vector<Vec3>& points = y_.surface().points;
    const Vec3 &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    const Sign side = orient3d(a, b, c, p) * orient2d(map(a), map(b), map(c));
    if (side == Sign::zero || is_fault_between(p, y_.locator()->height(hit.triangle, map(p)))) continue;
    (side == Sign::positive ? above : below) += working_.area(f);
  }
  return above > below ? 1 : above < below ? -1 : 0;
}

}  // namespace geomesh::geomodel
