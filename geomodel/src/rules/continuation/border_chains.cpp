// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/continuation/border_chains.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "common/union_find.hpp"
#include "naming/sheets.hpp"
#include "naming/sums.hpp"

namespace geomesh::geomodel {
namespace {

/// An edge of a border loop, in the loop's direction.
struct LoopEdge {
  VertexIndex a, b;
  Index triangle;
  double length;
  bool goes_on = true;       ///< false if the surface already reaches a bounding surface before this border edge
  std::uint8_t cut_off = 0;  ///< BorderChain::cut_off
  bool is_beyond = false;    ///< whether the border edge lies outside the model
  bool enters = false;       ///< whether the edge lies on a side of the box, with its triangle outside of it
  bool counts = true;  ///< false for edges outside the model, where the continuation will be cut off with the surface
  std::optional<Walls::Hit> hit{};  ///< the nearest bounding surface in front of the edge; `share` is its distance in m
};

Vec3 normalized(const Vec3& v) {
  const double length = norm(v);
  return length > 0 ? (1 / length) * v : Vec3{0, 0, 0};
}

/// Returns the direction away from the surface at a border edge, in the plane of its triangle.
Vec3 outward(const TriangulatedSurface& s, const LoopEdge& e) {
  const Vec3 along = normalized(s.points[e.b] - s.points[e.a]);
  Vec3 centre{0, 0, 0};
  for (const VertexIndex v : s.triangles[e.triangle]) centre = centre + (1.0 / 3) * s.points[v];
  const Vec3 inward = centre - s.points[e.a];
  return normalized(dot(inward, along) * along - inward);
}

bool is_within(const Box3& box, const Vec3& p, double room) {
  return p.x > box.min.x - room && p.y > box.min.y - room && p.z > box.min.z - room && p.x < box.max.x + room &&
         p.y < box.max.y + room && p.z < box.max.z + room;
}

/// Finds border vertices that a wall (bounding surface) separates from all inner vertices. The surface has then reached
/// that wall before its border, or ends on the wall. A wall that ends inside the surface separates no vertices.
class CutOffBorder {
 public:
  CutOffBorder(const TriangulatedSurface& s, const std::vector<BorderEdge>& border, Index row, const Walls& walls)
      : merged_(merge_equal_points(s.points)), joined_(s.points.size() + 1) {
    const auto inner = static_cast<Index>(s.points.size());  // union-find index for the surface's inner vertices
    std::vector<std::pair<Index, Index>> crossed;
    std::vector<std::uint8_t> is_border(s.points.size(), 0);
    for (const BorderEdge& e : border) is_border[e.a] = is_border[e.b] = 1;
    for (const Triangle& t : merged_triangles(s, merged_))
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexIndex v = t[i], w = t[(i + 1) % 3];
        if (!is_border[v] && !is_border[w]) continue;
        const Index a = is_border[v] ? v : inner, b = is_border[w] ? w : inner;
        if (joined_.find(a) == joined_.find(b)) continue;
        // Tests the edge in both directions, because a segment that begins on a bounding surface does not meet it.
        if (!walls.first_surface(s.points[v], s.points[w], row) && !walls.first_surface(s.points[w], s.points[v], row))
          joined_.unite(a, b);
        else
          crossed.emplace_back(a, b);
      }
    inner_ = joined_.find(inner);
    for (const auto& [a, b] : crossed)
      for (const auto& [out, in] : {std::pair(a, b), std::pair(b, a)})
        if (joined_.find(in) == inner_) cut_off_.insert(joined_.find(out));
    cut_off_.erase(inner_);
  }
  bool holds(VertexIndex v) { return cut_off_.contains(joined_.find(merged_[v])); }

 private:
  std::vector<VertexIndex> merged_;
  UnionFind joined_;
  Index inner_ = 0;
  std::set<Index> cut_off_;  ///< union-find roots of the border vertices that bounding surfaces cut off
};

struct WallSearch {
  Index row;
  const Walls& walls;
  double within, rounding;
};

/// Returns the nearest bounding surface in front of a place on a border edge, with the distance from the edge as its
/// `share`. The search begins at the distance `rounding` inside the surface, because a segment that begins on a
/// bounding surface does not count as meeting it; an edge that lies on its bounding surface then has it at distance 0.
/// If the edge enters the box, the search begins inside the box, because the side on which the edge lies does not end
/// the surface.
std::optional<Walls::Hit> wall_before(const TriangulatedSurface& s, const LoopEdge& e, double share,
                                      const WallSearch& search) {
  const auto& [row, walls, within, rounding] = search;
  const double begin = e.enters ? rounding : -rounding;
  const Vec3 out = outward(s, e), along = normalized(s.points[e.b] - s.points[e.a]);
  const Vec3 start = (1 - share) * s.points[e.a] + share * s.points[e.b] + begin * out;
  std::optional<Walls::Hit> nearest;
  for (const double turn : {0.0, 1.0, -1.0}) {
    const double length = within + rounding;
    std::optional<Walls::Hit> hit = walls.first_hit(start, start + length * normalized(out + turn * along), row);
    if (!hit) continue;
    hit->share = std::max(0.0, hit->share * length + begin);
    if (!nearest || hit->share < nearest->share) nearest = hit;
  }
  return nearest;
}

/// Returns the positions on a border edge (0 to 1) from which bounding surfaces in front of the edge are searched. This
/// is `middle`, unless bounding surfaces cut it off from the ends of the edge that are connected with the surface: then
/// the midpoints between these ends and the cuts, as far as they lie in the box.
std::vector<double> places_before_walls(const TriangulatedSurface& s, const LoopEdge& e, double middle, const Box3& box,
                                        const WallSearch& search) {
  const Vec3 &a = s.points[e.a], &b = s.points[e.b], m = (1 - middle) * a + middle * b;
  const std::optional<Walls::Hit> from_a = search.walls.first_hit(a, m, search.row),
                                  from_b = search.walls.first_hit(b, m, search.row);
  const bool holds_a = (e.cut_off & 1) == 0, holds_b = (e.cut_off & 2) == 0;
  if ((holds_a && !from_a) || (holds_b && !from_b)) return {middle};
  std::vector<double> shares;
  if (holds_a) shares.push_back(0.5 * from_a->share * middle);
  if (holds_b) shares.push_back(1 - 0.5 * from_b->share * (1 - middle));
  std::erase_if(shares, [&](double share) { return !is_within(box, (1 - share) * a + share * b, 0); });
  return shares.empty() ? std::vector<double>{middle} : shares;
}

/// Returns whether a border edge lies on its bounding surface up to rounding. It is tested at three points, because an
/// edge that crosses the bounding surface may touch it in its midpoint only.
bool lies_on_wall(const TriangulatedSurface& s, const LoopEdge& e, const WallSearch& search) {
  for (const double share : {0.25, 0.5, 0.75})
    if (const auto hit = wall_before(s, e, share, search); !hit || hit->share > search.rounding) return false;
  return true;
}

/// Assigns the bounding surface of the previous edge to short runs of border edges that have none in front of them.
void close_short_runs(std::vector<LoopEdge>& loop, double within) {
  const std::size_t n = loop.size();
  const auto first = std::find_if(loop.begin(), loop.end(), [](const LoopEdge& e) { return e.hit.has_value(); });
  if (first == loop.end()) return;
  std::rotate(loop.begin(), first, loop.end());
  for (std::size_t k = 0; k < n; ++k) {
    if (loop[k].hit) continue;
    std::size_t end = k;
    double length = 0;
    for (; end < n && !loop[end].hit; ++end) length += loop[end].length;
    if (length <= within) {
      for (std::size_t i = k; i < end; ++i) {
        loop[i].hit = loop[k - 1].hit;
        loop[i].hit->share = 0;
      }
    }
    k = end;
  }
}

BorderChain chain_of(const TriangulatedSurface& s, const std::vector<LoopEdge>& edges) {
  BorderChain chain;
  for (const LoopEdge& e : edges) {
    chain.vertices.push_back(e.a);
    chain.triangles.push_back(e.triangle);
    chain.goes_on.push_back(e.goes_on);
    chain.cut_off.push_back(e.cut_off);
    if (!e.goes_on || !e.counts) continue;
    chain.walls.push_back(e.hit->surface);
    chain.length += e.length;
    if (e.hit->share < chain.farthest) continue;
    chain.farthest = e.hit->share;
    chain.place = 0.5 * (s.points[e.a] + s.points[e.b]);
  }
  chain.closed = edges.back().b == edges.front().a;
  if (!chain.closed) chain.vertices.push_back(edges.back().b);
  std::sort(chain.walls.begin(), chain.walls.end());
  chain.walls.erase(std::unique(chain.walls.begin(), chain.walls.end()), chain.walls.end());
  return chain;
}

/// Divides a loop of border edges into chains, separated by edges that have no bounding surface in front of them.
void cut_loop(const TriangulatedSurface& s, std::vector<LoopEdge> loop, std::vector<BorderChain>& chains) {
  const std::size_t n = loop.size();
  const auto keep = [&](const std::vector<LoopEdge>& run) {
    if (std::any_of(run.begin(), run.end(), [](const LoopEdge& e) { return e.goes_on && e.counts; }))
      chains.push_back(chain_of(s, run));
  };
  const auto ends_after = [&](std::size_t k) {  // whether a chain of border edges ends between edge k and the next
    return !loop[k].hit || !loop[(k + 1) % n].hit;
  };
  std::size_t cut = n;
  for (std::size_t k = 0; k < n && cut == n; ++k)
    if (ends_after(k)) cut = k;
  if (cut == n) {
    if (loop.front().hit) keep(loop);
    return;
  }
  std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>((cut + 1) % n), loop.end());
  std::vector<LoopEdge> run;
  for (std::size_t k = 0; k < n; ++k) {
    if (loop[k].hit) run.push_back(loop[k]);
    if (!run.empty() && (k + 1 == n || ends_after(k))) {
      keep(run);
      run.clear();
    }
  }
}

/// Returns the position on the edge from a to b (0 to 1) at which bounding surfaces are searched: its midpoint, or, if
/// that is outside the box, the midpoint of its part inside.
double middle_in(const Box3& box, const Vec3& a, const Vec3& b, double rounding) {
  if (is_within(box, 0.5 * (a + b), 0)) return 0.5;
  double first = 0, last = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const double way = b[i] - a[i];
    if (way == 0) continue;
    const double enters = ((way > 0 ? box.min[i] : box.max[i]) - a[i]) / way,
                 leaves = ((way > 0 ? box.max[i] : box.min[i]) - a[i]) / way;
    first = std::max(first, enters), last = std::min(last, leaves);
  }
  const double middle = (first + last) / 2;
  return first < last && is_within(box, (1 - middle) * a + middle * b, -rounding) ? middle : 0.5;
}

/// Options for the search for bounding surfaces in front of a surface's border.
struct BorderSearch {
  Index row;
  const Walls& walls;
  const Box3& box;
  double within;
  /// Whether a border edge counts as continued if only a part of it stops short of a bounding surface. If false, the
  /// edge's midpoint decides, since strips of triangles continue whole edges.
  bool by_parts;
};

/// Returns loops of border edges, with the bounding surface in front of each edge; none for triangles marked `done`.
std::vector<std::vector<LoopEdge>> loops_with_walls(const TriangulatedSurface& surface, const BorderSearch& how,
                                                    const std::vector<bool>& done) {
  const auto& [row, walls, box, within, by_parts] = how;
  const std::vector<BorderEdge> edges = border_edges(surface);
  std::map<std::pair<VertexIndex, VertexIndex>, Index> triangle_at;
  for (const BorderEdge& e : edges) triangle_at[{e.a, e.b}] = e.triangle;
  CutOffBorder cut_off(surface, edges, row, walls);
  double largest = 0;  // coordinate
  for (std::size_t i = 0; i < 3; ++i) largest = std::max({largest, std::abs(box.min[i]), std::abs(box.max[i])});
  const double rounding = 1024 * std::numeric_limits<double>::epsilon() * largest;
  const WallSearch search{row, walls, within, rounding};
  std::vector<std::vector<LoopEdge>> loops;
  for (const std::vector<VertexIndex>& vertices : border_loops(edges).loops) {
    std::vector<LoopEdge>& loop = loops.emplace_back();
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      const VertexIndex a = vertices[k], b = vertices[(k + 1) % vertices.size()];
      LoopEdge e{a, b, triangle_at.at({a, b}), norm(surface.points[b] - surface.points[a])};
      const double share = middle_in(box, surface.points[a], surface.points[b], rounding);
      const Vec3 middle = (1 - share) * surface.points[a] + share * surface.points[b];
      if (e.triangle < done.size() && done[e.triangle]) {
        e.goes_on = false;
        loop.push_back(e);
        continue;
      }
      const Vec3 in_front = middle + 2 * rounding * outward(surface, e);
      e.enters = !is_within(box, middle, 0) && is_within(box, in_front, 0);
      e.cut_off = static_cast<std::uint8_t>((cut_off.holds(a) ? 1 : 0) + (cut_off.holds(b) ? 2 : 0));
      e.goes_on = e.cut_off != 3;
      if (!e.goes_on)
        e.hit = Walls::Hit{};
      else if (is_within(box, middle, std::max(within, e.length)))
        for (const double place : by_parts ? places_before_walls(surface, e, share, box, search) : std::vector{share})
          if (const auto hit = wall_before(surface, e, place, search); hit && (!e.hit || hit->share < e.hit->share))
            e.hit = hit;
      if (e.hit && e.goes_on && lies_on_wall(surface, e, search)) e.goes_on = false;
      e.is_beyond = !e.enters && !is_within(box, middle, 0);
      if (e.is_beyond && (!e.hit || e.hit->surface == Walls::side_of_volume)) {
        e.hit = Walls::Hit{};
        e.counts = false;
      }
      loop.push_back(e);
    }
    close_short_runs(loop, within);
  }
  return loops;
}

}  // namespace

BorderStates border_states(const TriangulatedSurface& surface, Index row, const Walls& walls, const Box3& box,
                           double within) {
  BorderStates states;
  for (const std::vector<LoopEdge>& loop : loops_with_walls(surface, {row, walls, box, within, true}, {}))
    for (const LoopEdge& e : loop)
      states[{e.a, e.b}] = !e.goes_on || e.is_beyond ? BorderState::met_wall
                           : e.hit                   ? BorderState::before_wall
                                                     : BorderState::open;
  return states;
}

std::map<Index, double> lengths_before(const TriangulatedSurface& surface, Index row, const Walls& walls,
                                       const Box3& box, double within) {
  std::map<Index, double> lengths;
  for (const std::vector<LoopEdge>& loop : loops_with_walls(surface, {row, walls, box, within, false}, {}))
    for (const LoopEdge& e : loop)
      if (e.hit && !e.is_beyond) lengths[e.hit->surface] += e.length;
  return lengths;
}

std::vector<BorderChain> chains_before_walls(const TriangulatedSurface& surface, Index row, const Walls& walls,
                                             const Box3& box, double within, const std::vector<bool>& done) {
  std::vector<BorderChain> chains;
  for (std::vector<LoopEdge>& loop : loops_with_walls(surface, {row, walls, box, within, false}, done))
    cut_loop(surface, std::move(loop), chains);
  return chains;
}

}  // namespace geomesh::geomodel
