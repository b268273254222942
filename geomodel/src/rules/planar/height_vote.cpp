// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/planar/height_vote.hpp"

#include "geomesh/core/predicates.hpp"

namespace geomesh::geomodel {
namespace {

Vec2 map(const Vec3& p) { return {p.x, p.y}; }

}  // namespace

HeightVote::HeightVote(const WorkingSoup& working, Index y) : working_(working) {
  left_.points = working.soup.points;
  for (Index f = 0; f < working.soup.facets.size(); ++f)
    if (working.has(f, y)) left_.triangles.push_back(working.soup.facets[f]);
  if (!left_.triangles.empty()) locator_.emplace(left_);
}

int HeightVote::side_of(const Piece& piece) const {
  double above = 0, below = 0;
  for (const Index f : piece.facets) {
    const Vec3 p = working_.centre(f);
    const MapLocator::Hit hit = locator_ ? locator_->find(map(p)) : MapLocator::Hit{};
    if (hit.count != 1 || !hit.strictly) continue;
    const Triangle& t = left_.triangles[hit.triangle];
    const Vec3 &a = left_.points[t[0]], &b = left_.points[t[1]], &c = left_.points[t[2]];
    const Sign side = orient3d(a, b, c, p) * orient2d(map(a), map(b), map(c));
    if (side != Sign::zero) (side == Sign::positive ? above : below) += working_.area(f);
  }
  return above > below ? 1 : above < below ? -1 : 0;
}

}  // namespace geomesh::geomodel
