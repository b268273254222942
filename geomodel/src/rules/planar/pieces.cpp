// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/planar/pieces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "common/union_find.hpp"
#include "geomesh/core/predicates.hpp"
#include "naming/sums.hpp"

namespace geomesh::geomodel {

namespace {

VertexIndex apex_of(const Triangle& t, VertexIndex a, VertexIndex b) {
  for (VertexIndex v : t)
    if (v != a && v != b) return v;
  return t[0];
}

bool runs_from(const Triangle& t, VertexIndex a, VertexIndex b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (t[i] == a && t[(i + 1) % 3] == b) return true;
  return false;
}

/// Returns whether facet f of surface y, with its normal turned to the upper side of y, traverses the edge from a to b.
bool runs_upward(const WorkingSoup& w, Index f, Index y, const UpwardSides& sides, VertexIndex a, VertexIndex b) {
  const PolygonSoup::Origin& o = *w.origin_of(f, y);
  const bool facet_is_up = (sides.as_stored[o.triangle] != 0) != o.reversed;
  return runs_from(w.soup.facets[f], a, b) == facet_is_up;
}

/// Returns whether two facets lie on different sides of their common edge in the map.
bool are_apart(const WorkingSoup& w, const EdgeUse& edge, Index f, Index g) {
  const Vec3 &a = w.soup.points[edge.a], &b = w.soup.points[edge.b];
  const auto side = [&](Index facet) {
    const Vec3& p = w.soup.points[apex_of(w.soup.facets[facet], edge.a, edge.b)];
    return orient2d({a.x, a.y}, {b.x, b.y}, {p.x, p.y});
  };
  return side(f) * side(g) == Sign::negative;
}

/// Returns the side of point d, beside an edge, relative to the facets of surface y at that edge: 1 above, -1 below, 0
/// on it or undecided. If y has one facet, it ends there; if two, d is in the upper or the lower wedge.
int side_at_edge(const WorkingSoup& w, const EdgeUse& edge, const std::vector<Index>& of_y, Index y,
                 const UpwardSides& sides, VertexIndex d) {
  const VertexIndex a = edge.a, b = edge.b;
  const auto orient = [&](VertexIndex c, VertexIndex e) {
    return orient3d(w.soup.points[a], w.soup.points[b], w.soup.points[c], w.soup.points[e]);
  };
  if (of_y.size() == 1) {
    const Sign s = orient(apex_of(w.soup.facets[of_y[0]], a, b), d);
    return static_cast<int>(runs_upward(w, of_y[0], y, sides, a, b) ? s : -s);
  }
  if (of_y.size() != 2) return 0;
  Index from = of_y[0], to = of_y[1];  // the space above surface y is counter-clockwise about ab from `from` to `to`
  if (!runs_upward(w, from, y, sides, a, b)) std::swap(from, to);
  if (!runs_upward(w, from, y, sides, a, b) || runs_upward(w, to, y, sides, a, b)) return 0;
  const VertexIndex c1 = apex_of(w.soup.facets[from], a, b), c2 = apex_of(w.soup.facets[to], a, b);
  const Sign s1 = orient(c1, d), s2 = orient(d, c2), wedge = orient(c1, c2);
  if (wedge == Sign::positive) return s1 == Sign::positive && s2 == Sign::positive ? 1 : -1;
  if (wedge == Sign::negative) return s1 == Sign::positive || s2 == Sign::positive ? 1 : -1;
  return static_cast<int>(s1);
}

}  // namespace

WorkingSoup::WorkingSoup(const PolygonSoup& s) : soup(s), uses(sorted_edge_uses(s.facets)), origins(s.facets.size()) {
  for (Index f = 0; f < s.facets.size(); ++f)
    origins[f].assign(s.origins.begin() + s.origin_offsets[f], s.origins.begin() + s.origin_offsets[f + 1]);
}

const PolygonSoup::Origin* WorkingSoup::origin_of(Index facet, Index surface) const {
  for (const PolygonSoup::Origin& o : origins[facet])
    if (o.surface == surface) return &o;
  return nullptr;
}

double WorkingSoup::area(Index facet) const {
  const Triangle& t = soup.facets[facet];
  return triangle_area(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]);
}

Vec3 WorkingSoup::centre(Index facet) const {
  const Triangle& t = soup.facets[facet];
  return (1.0 / 3) * (soup.points[t[0]] + soup.points[t[1]] + soup.points[t[2]]);
}

double WorkingSoup::remove(const std::vector<Index>& facets, Index surface) {
  return remove(facets, [&](const PolygonSoup::Origin& o) { return o.surface == surface; });
}

double WorkingSoup::remove(const std::vector<Index>& facets,
                           const std::function<bool(const PolygonSoup::Origin&)>& goes) {
  CompensatedSum sum;
  for (Index f : facets) sum.add(static_cast<double>(std::erase_if(origins[f], goes)) * area(f));
  return sum.value();
}

PolygonSoup WorkingSoup::result() const {
  PolygonSoup out;
  std::vector<VertexIndex> row(soup.points.size(), no_vertex);
  std::vector<bool> used(soup.points.size(), false);
  for (Index f = 0; f < soup.facets.size(); ++f)
    if (alive(f))
      for (VertexIndex v : soup.facets[f]) used[v] = true;
  for (const auto& s : soup.segments) used[s.a] = used[s.b] = true;
  for (const auto& p : soup.isolated_points) used[p.v] = true;
  for (VertexIndex v = 0; v < soup.points.size(); ++v) {
    if (!used[v]) continue;
    row[v] = static_cast<VertexIndex>(out.points.size());
    out.points.push_back(soup.points[v]);
    out.kind.push_back(soup.kind[v]);
    out.input_point.push_back(soup.input_point[v]);
  }
  for (Index f = 0; f < soup.facets.size(); ++f) {
    if (!alive(f)) continue;
    Triangle t = soup.facets[f];
    // A facet has the orientation of its first origin (input triangle). If that origin was removed, the facet is
    // flipped to match the origin that has become the first one.
    const bool turn = origins[f].front().reversed;
    if (turn) std::swap(t[1], t[2]);
    out.facets.push_back({row[t[0]], row[t[1]], row[t[2]]});
    for (PolygonSoup::Origin o : origins[f]) {
      o.reversed = o.reversed != turn;
      out.origins.push_back(o);
    }
    out.origin_offsets.push_back(static_cast<Index>(out.origins.size()));
  }
  for (const auto& s : soup.segments) out.segments.push_back({row[s.a], row[s.b], s.polyline});
  for (const auto& p : soup.isolated_points) out.isolated_points.push_back({row[p.v], p.point});
  return out;
}

std::vector<Piece> pieces_of(const WorkingSoup& w, Index x, const std::vector<Index>& cutters, const UpwardSides* sides,
                             BeyondEnd beyond, const std::vector<Index>& dividers) {
  return pieces_of(
      w, [&](Index f) { return w.has(f, x); }, cutters, sides, beyond, dividers);
}

std::vector<Piece> pieces_of(const WorkingSoup& w, const std::function<bool(Index)>& is_mine,
                             const std::vector<Index>& cutters, const UpwardSides* sides, BeyondEnd beyond,
                             const std::vector<Index>& dividers) {
  const auto is_of = [&](const std::vector<Index>& surfaces, Index f) {
    return std::any_of(surfaces.begin(), surfaces.end(), [&](Index c) { return w.has(f, c); });
  };
  const auto is_cutter = [&](Index f) { return is_of(cutters, f); };
  const auto parts = [&](Index f) { return is_cutter(f) || is_of(dividers, f); };
  std::vector<std::uint8_t> mine(w.soup.facets.size(), 0);
  for (Index f = 0; f < mine.size(); ++f) mine[f] = is_mine(f) && !is_cutter(f);
  UnionFind joined(mine.size());
  for_each_edge(w.uses, [&](std::span<const EdgeUse> edge) {
    if (std::any_of(edge.begin(), edge.end(), [&](const EdgeUse& u) { return parts(u.facet); })) return;
    Index first = no_index;
    for (const EdgeUse& u : edge) {
      if (!mine[u.facet]) continue;
      if (first != no_index) joined.unite(first, u.facet);
      first = u.facet;
    }
  });
  std::map<Index, std::size_t> row;
  std::vector<Piece> pieces;
  for (Index f = 0; f < mine.size(); ++f) {
    if (!mine[f]) continue;
    const auto [at, is_new] = row.emplace(joined.find(f), pieces.size());
    if (is_new) pieces.emplace_back();
    Piece& piece = pieces[at->second];
    piece.facets.push_back(f);
    piece.area += w.area(f);
    if (piece.largest == no_index || w.area(f) > w.area(piece.largest)) piece.largest = f;
  }
  for_each_edge(w.uses, [&](std::span<const EdgeUse> edge) {
    std::vector<Index> here, of_cutter;
    std::size_t n_alive = 0;
    for (const EdgeUse& u : edge) {
      if (!w.alive(u.facet)) continue;
      ++n_alive;
      if (mine[u.facet]) here.push_back(u.facet);
      if (is_cutter(u.facet)) of_cutter.push_back(u.facet);
    }
    const double length = norm(w.soup.points[edge[0].b] - w.soup.points[edge[0].a]);
    for (Index f : here) {
      Piece& piece = pieces[row.at(joined.find(f))];
      if (n_alive == 1) piece.free_border += length;
      if (!of_cutter.empty()) piece.contact += length;
      if (!sides || of_cutter.empty()) continue;
      if (beyond == BeyondEnd::has_none && of_cutter.size() == 1 && are_apart(w, edge[0], of_cutter[0], f)) continue;
      const int side =
          side_at_edge(w, edge[0], of_cutter, cutters.front(), *sides, apex_of(w.soup.facets[f], edge[0].a, edge[0].b));
      (side > 0 ? piece.above : piece.below) += side == 0 ? 0 : length;
    }
  });
  return pieces;
}

int side_of(const WorkingSoup& w, const Piece& piece, Index y, const UpwardSides& sides) {
  if (piece.above != piece.below) return piece.above > piece.below ? 1 : -1;
  const Vec3 p = w.centre(piece.largest);
  const auto map = [](const Vec3& q) { return Vec2{q.x, q.y}; };
  double nearest = std::numeric_limits<double>::infinity();
  int side = 0;
  for (Index f = 0; f < w.soup.facets.size(); ++f) {
    const PolygonSoup::Origin* o = w.origin_of(f, y);
    if (!o) continue;
    const Triangle& t = w.soup.facets[f];
    const Vec3 &a = w.soup.points[t[0]], &b = w.soup.points[t[1]], &c = w.soup.points[t[2]];
    const int s0 = static_cast<int>(orient2d(map(a), map(b), map(p))),
              s1 = static_cast<int>(orient2d(map(b), map(c), map(p))),
              s2 = static_cast<int>(orient2d(map(c), map(a), map(p)));
    const bool inside = (s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0);
    if (!inside || (s0 == 0 && s1 == 0 && s2 == 0)) continue;
    const double distance = std::abs(p.z - w.centre(f).z);
    if (distance >= nearest) continue;
    nearest = distance;
    const bool facet_is_up = (sides.as_stored[o->triangle] != 0) != o->reversed;
    const int over = static_cast<int>(orient3d(a, b, c, p));
    side = facet_is_up ? over : -over;
  }
  return side;
}

}  // namespace geomesh::geomodel
