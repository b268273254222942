// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/planar/single_valued.hpp"

#include <algorithm>
#include <array>

#include "geomesh/core/predicates.hpp"
#include "naming/sheets.hpp"

namespace geomesh::geomodel {
namespace {

struct EdgeSide {
  VertexIndex a, b;  ///< the lesser first
  Sign side;         ///< side of the edge on which the triangle's third point lies
  friend bool operator<(const EdgeSide& x, const EdgeSide& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; }
};

}  // namespace

bool is_single_valued(const TriangulatedSurface& surface) {
  const auto map = [&](VertexIndex v) { return Vec2{surface.points[v].x, surface.points[v].y}; };
  std::vector<EdgeSide> sides;
  sides.reserve(3 * surface.triangles.size());
  for (const Triangle& t : merged_triangles(surface))
    for (std::size_t i = 0; i < 3; ++i) {
      VertexIndex a = t[i], b = t[(i + 1) % 3];
      if (a == b) continue;
      if (a > b) std::swap(a, b);
      const Sign side = orient2d(map(a), map(b), map(t[(i + 2) % 3]));
      if (side == Sign::zero) return false;
      sides.push_back({a, b, side});
    }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && !(sides[i] < sides[end])) ++end;
    if (end - i > 2 || (end - i == 2 && sides[i].side == sides[i + 1].side)) return false;
    i = end;
  }
  return !sides.empty();
}

}  // namespace geomesh::geomodel
