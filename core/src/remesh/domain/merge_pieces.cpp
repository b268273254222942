// SPDX-License-Identifier: MIT
#include "remesh/domain/merge_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "common/geometry.hpp"
#include "plc/facet_triangulation.hpp"

namespace geomesh::remesh {

namespace {

using Edge = std::array<VertexIndex, 2>;
using Loop = std::vector<VertexIndex>;

/// Tolerances of coplanarity, in units in the last place of the largest coordinate. Rounding moves a point, and the
/// plane of a group of triangles, by less than one unit. While a group grows from its largest triangle, the plane of
/// that triangle may be farther off.
constexpr double plane_ulps = 2, growing_ulps = 16;

/// The border of a set of triangles that will become one facet.
struct Outline {
  std::vector<Loop> loops;  ///< outer loop first
  std::vector<Edge> segments;
  std::vector<VertexIndex> points;
};

struct EdgeUse {
  Edge edge;
  Index facet;  ///< no_index: a segment
};

std::vector<EdgeUse> edge_uses(const PiecewiseLinearComplex& plc) {
  std::vector<EdgeUse> uses;
  for_each_side(plc, [&](Index f, VertexIndex a, VertexIndex b) { uses.push_back({sorted(Edge{a, b}), f}); });
  for (const auto& s : plc.facet_segments) uses.push_back({sorted(Edge{s.a, s.b}), no_index});
  for (const auto& s : plc.segments) uses.push_back({sorted(Edge{s.a, s.b}), no_index});
  std::sort(uses.begin(), uses.end(),
            [](const EdgeUse& a, const EdgeUse& b) { return a.edge != b.edge ? a.edge < b.edge : a.facet < b.facet; });
  return uses;
}

/// Groups of coplanar pieces of one input triangle, connected across edges at which no other facet ends.
class PlaneGroups {
 public:
  PlaneGroups(const PiecewiseLinearComplex& plc, std::span<const Index> parent, std::span<const EdgeUse> uses)
      : plc_(plc), parent_(parent), joined_(plc.n_facets(), {no_index, no_index, no_index}) {
    double largest = 0;
    for (const Vec3& p : plc.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    ulp_ = largest * std::numeric_limits<double>::epsilon();
    join_across_edges(uses);
  }

  /// Calls visit(members, normal) for each group of at least two triangles, each grown from its largest triangle, whose
  /// plane is the most accurate.
  template <class Visit>
  void grow(const Visit& visit) const {
    std::vector<std::pair<double, Index>> order;
    for (Index f = 0; f < plc_.n_facets(); ++f)
      if (may_merge(f)) order.push_back({-length(normal_of(f)), f});
    std::sort(order.begin(), order.end());
    std::vector<bool> taken(plc_.n_facets(), false);
    for (const auto& [area, seed] : order) {
      if (taken[seed] || !(area < 0)) continue;
      taken[seed] = true;
      const Vec3 origin = plc_.points[plc_.outer_loop(seed)[0]], normal = (-1 / area) * normal_of(seed);
      std::vector<Index> members{seed};
      for (std::size_t k = 0; k < members.size(); ++k)
        for (const Index g : joined_[members[k]]) {
          if (g == no_index || taken[g] || !is_in_plane(g, origin, normal, growing_ulps)) continue;
          taken[g] = true;
          members.push_back(g);
        }
      if (members.size() > 1 && are_in_mean_plane(members)) visit(std::move(members), normal);
    }
  }

 private:
  bool may_merge(Index f) const {
    return f < parent_.size() && parent_[f] != no_index && plc_.n_loops(f) == 1 && plc_.outer_loop(f).size() == 3;
  }

  /// Returns the position of the edge (a, b) in the triangle's loop, or 3 if the loop does not contain it.
  std::size_t place_of(Index f, VertexIndex a, VertexIndex b) const {
    const auto t = plc_.outer_loop(f);
    std::size_t k = 0;
    while (k < 3 && (t[k] != a || t[(k + 1) % 3] != b)) ++k;
    return k;
  }

  /// Marks two facets as neighbours if they alone meet at an edge and are equally oriented pieces of a triangle.
  void join_across_edges(std::span<const EdgeUse> uses) {
    for (std::size_t i = 0, j; i < uses.size(); i = j) {
      for (j = i; j < uses.size() && uses[j].edge == uses[i].edge;) ++j;
      const Index f = uses[i].facet, g = uses[j - 1].facet;
      if (j - i != 2 || f == no_index || g == no_index || f == g || !may_merge(f) || !may_merge(g) ||
          parent_[f] != parent_[g])
        continue;
      auto [a, b] = uses[i].edge;
      if (place_of(f, a, b) == 3) std::swap(a, b);
      const std::size_t in_f = place_of(f, a, b), in_g = place_of(g, b, a);
      if (in_g == 3) continue;
      joined_[f][in_f] = g;
      joined_[g][in_g] = f;
    }
  }

  Vec3 normal_of(Index f) const { return loop_normal(plc_.points, plc_.outer_loop(f)); }

  bool is_in_plane(Index f, const Vec3& origin, const Vec3& unit_normal, double ulps) const {
    const auto t = plc_.outer_loop(f);
    return dot(normal_of(f), unit_normal) > 0 && std::all_of(t.begin(), t.end(), [&](VertexIndex v) {
             return std::abs(dot(plc_.points[v] - origin, unit_normal)) <= ulps * ulp_;
           });
  }

  /// Returns whether all facets of a group to be merged lie in their mean plane (facets weighted by area).
  bool are_in_mean_plane(const std::vector<Index>& members) const {
    Vec3 normal, middle;
    double weight = 0;
    const Vec3 origin = plc_.points[plc_.outer_loop(members[0])[0]];
    for (const Index f : members) {
      const Vec3 n = normal_of(f);
      const double w = length(n);
      normal = normal + n;
      weight += w;
      for (const VertexIndex v : plc_.outer_loop(f)) middle = middle + (w / 3) * (plc_.points[v] - origin);
    }
    normal = (1 / length(normal)) * normal;
    middle = origin + (1 / weight) * middle;
    return std::all_of(members.begin(), members.end(),
                       [&](Index f) { return is_in_plane(f, middle, normal, plane_ulps); });
  }

  const PiecewiseLinearComplex& plc_;
  std::span<const Index> parent_;
  double ulp_;                                // rounding unit of the largest coordinate
  std::vector<std::array<Index, 3>> joined_;  // neighbouring facet across each edge, for each facet
};

/// Outlines of groups of triangles that are merged, and of each group the points and edges that other facets use. A
/// group is identified by its first facet.
class Outlines {
 public:
  Outlines(const PiecewiseLinearComplex& plc, std::span<const EdgeUse> uses)
      : plc_(plc), uses_(uses), group_(plc.n_facets()), used_by_others_(plc.points.size(), false) {
    std::iota(group_.begin(), group_.end(), 0);
    facets_at_.resize(plc_.points.size());
    for (const EdgeUse& u : uses_)
      if (u.facet == no_index) used_by_others_[u.edge[0]] = used_by_others_[u.edge[1]] = true;
    for (const auto& p : plc_.facet_points) used_by_others_[p.v] = true;
    for (const VertexIndex v : plc_.isolated_points) used_by_others_[v] = true;
    for_each_side(plc, [&](Index f, VertexIndex a, VertexIndex) { facets_at_[a].push_back(f); });
  }

  void add(std::vector<Index> members, const Vec3& normal) {
    std::sort(members.begin(), members.end());
    for (const Index f : members) group_[f] = members.front();
    if (std::optional<Outline> outline = outline_of(members, normal))
      outlines_.emplace(members.front(), std::move(*outline));
    else
      for (const Index f : members) group_[f] = f;
  }

  Index group_of(Index f) const { return group_[f]; }
  /// Returns the outline of the group of merged facets whose first facet is f; null if f is not the first of a group.
  const Outline* find(Index f) const {
    const auto at = outlines_.find(f);
    return at == outlines_.end() ? nullptr : &at->second;
  }

 private:
  std::span<const EdgeUse> uses_of(const Edge& e) const {
    const auto range = std::equal_range(uses_.begin(), uses_.end(), EdgeUse{e, 0},
                                        [](const EdgeUse& a, const EdgeUse& b) { return a.edge < b.edge; });
    return {range.first, range.second};
  }

  std::optional<Outline> outline_of(const std::vector<Index>& members, const Vec3& normal) const {
    Outline outline;
    std::map<VertexIndex, VertexIndex> next;
    std::set<VertexIndex> open;
    std::set<Edge> seen;
    const Index group = members.front();
    for (const Index f : members) {
      const auto t = plc_.outer_loop(f);
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexIndex a = t[i], b = t[(i + 1) % 3];
        const Edge edge = sorted(Edge{a, b});
        const auto uses = uses_of(edge);
        const auto n_own = std::count_if(uses.begin(), uses.end(), [&](const EdgeUse& u) {
          return u.facet != no_index && group_[u.facet] == group;
        });
        open.insert(a);
        if (n_own > 2 || (n_own == 1 && !next.emplace(a, b).second)) return std::nullopt;
        if (n_own == 2 && uses.size() > 2 && seen.insert(edge).second) outline.segments.push_back(edge);
      }
    }
    if (!trace(next, outline.loops)) return std::nullopt;
    put_outer_first(normal, outline.loops);
    for (const Loop& loop : outline.loops)
      for (const VertexIndex v : loop) open.erase(v);
    for (const Edge& e : outline.segments) open.erase(e[0]), open.erase(e[1]);
    for (const VertexIndex v : open)
      if (is_used_elsewhere(v, group)) outline.points.push_back(v);
    return is_facet(outline) ? std::optional(std::move(outline)) : std::nullopt;
  }

  /// Returns whether the outline is a valid facet. Rounding may place inner vertices on the border, e.g. of a sliver.
  bool is_facet(const Outline& outline) const {
    FacetFault fault;
    return triangulate_facet(plc_.points, {outline.loops, outline.segments, outline.points}, fault).has_value();
  }

  static bool trace(const std::map<VertexIndex, VertexIndex>& next, std::vector<Loop>& loops) {
    std::set<VertexIndex> seen;
    for (const auto& [start, second] : next) {
      if (seen.contains(start)) continue;
      Loop& loop = loops.emplace_back();
      for (VertexIndex v = start; seen.insert(v).second;) {
        loop.push_back(v);
        const auto at = next.find(v);
        if (at == next.end()) return false;
        v = at->second;
      }
    }
    return !loops.empty();
  }

  /// Puts the outer loop of a facet first; it is the only loop with a positive area about the facet's normal.
  void put_outer_first(const Vec3& normal, std::vector<Loop>& loops) const {
    const auto area = [&](const Loop& loop) { return dot(loop_normal(plc_.points, loop), normal); };
    std::iter_swap(loops.begin(), std::max_element(loops.begin(), loops.end(),
                                                   [&](const Loop& a, const Loop& b) { return area(a) < area(b); }));
  }

  bool is_used_elsewhere(VertexIndex v, Index group) const {
    return used_by_others_[v] ||
           std::any_of(facets_at_[v].begin(), facets_at_[v].end(), [&](Index f) { return group_[f] != group; });
  }

  const PiecewiseLinearComplex& plc_;
  std::span<const EdgeUse> uses_;
  std::vector<Index> group_;  // for each facet, the first facet of the group with which it is merged
  std::vector<std::vector<Index>> facets_at_;
  std::vector<bool> used_by_others_;
  std::map<Index, Outline> outlines_;
};

/// Adds facet f, or the merged facet with the given outline, to the complex `out`. Returns the index of the new facet.
Index write_facet(const PiecewiseLinearComplex& plc, Index f, const Outline* outline, PiecewiseLinearComplex& out) {
  if (outline) {
    const Index row = out.add_polygon(outline->loops, plc.facet_provenance[f]);
    for (const auto& [a, b] : outline->segments) out.facet_segments.push_back({row, a, b});
    for (const VertexIndex v : outline->points) out.facet_points.push_back({row, v});
    return row;
  }
  std::vector<Loop> loops;
  for (Index l = plc.facet_loops[f]; l < plc.facet_loops[f + 1]; ++l)
    loops.emplace_back(plc.loop(l).begin(), plc.loop(l).end());
  return out.add_polygon(loops, plc.facet_provenance[f]);
}

}  // namespace

PiecewiseLinearComplex without_facets(const PiecewiseLinearComplex& plc) {
  PiecewiseLinearComplex out;
  out.points = plc.points;
  out.provenance_sets = plc.provenance_sets;
  out.segments = plc.segments;
  out.isolated_points = plc.isolated_points;
  out.region_seeds = plc.region_seeds;
  out.hole_seeds = plc.hole_seeds;
  return out;
}

MergedFacets merge_pieces(const PiecewiseLinearComplex& plc, std::span<const Index> parent) {
  const std::vector<EdgeUse> uses = edge_uses(plc);
  Outlines outlines(plc, uses);
  PlaneGroups(plc, parent, uses).grow([&](std::vector<Index> members, const Vec3& normal) {
    outlines.add(std::move(members), normal);
  });
  MergedFacets out{without_facets(plc), {}};
  for (Index f = 0; f < plc.n_facets(); ++f) {
    const Index first = outlines.group_of(f);
    const Index row = first < f ? out.row_of_facet[first] : write_facet(plc, f, outlines.find(f), out.plc);
    out.row_of_facet.push_back(row);
  }
  for (const auto& s : plc.facet_segments) out.plc.facet_segments.push_back({out.row_of_facet[s.facet], s.a, s.b});
  for (const auto& p : plc.facet_points) out.plc.facet_points.push_back({out.row_of_facet[p.facet], p.v});
  return out;
}

bool take_apart(const MergedFacets& merged, std::vector<Index> rows, std::vector<Index>& parent) {
  std::sort(rows.begin(), rows.end());
  std::vector<Index> n_merged(merged.plc.n_facets(), 0);
  for (const Index row : merged.row_of_facet) ++n_merged[row];
  bool any = false;
  for (Index f = 0; f < parent.size(); ++f) {
    const Index row = merged.row_of_facet[f];
    if (n_merged[row] < 2 || !std::binary_search(rows.begin(), rows.end(), row)) continue;
    parent[f] = no_index;
    any = true;
  }
  return any;
}

}  // namespace geomesh::remesh
