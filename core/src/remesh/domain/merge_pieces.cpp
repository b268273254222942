// SPDX-License-Identifier: MIT
#include "remesh/domain/merge_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "quality/measure/shape.hpp"

namespace geomesh::remesh {

namespace {

using Edge = std::array<VertexIndex, 2>;
using Loop = std::vector<VertexIndex>;

/// Rounding moves a point by less than one ulp, and the plane of a group as much. The plane of its largest piece may
/// lie farther off.
constexpr double plane_ulps = 2, growing_ulps = 16;

Edge edge_of(VertexIndex a, VertexIndex b) { return {std::min(a, b), std::max(a, b)}; }

/// Border of a set of triangles that is to be one facet.
struct Outline {
  std::vector<Loop> loops;  ///< the outer one first
  std::vector<Edge> segments;
  std::vector<VertexIndex> points;
};

class PieceMerger {
 public:
  PieceMerger(const PiecewiseLinearComplex& plc, std::span<const Index> parent)
      : plc_(plc), parent_(parent), group_(plc.n_facets()) {
    std::iota(group_.begin(), group_.end(), 0);
    double largest = 0;
    for (const Vec3& p : plc.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    ulp_ = largest * std::numeric_limits<double>::epsilon();
  }

  MergedFacets run() {
    collect_edges();
    count_uses();
    join_across_edges();
    grow_groups();
    out_.row_of_facet.assign(plc_.n_facets(), no_index);
    copy_all_but_facets();
    for (Index f = 0; f < plc_.n_facets(); ++f)
      out_.row_of_facet[f] = group_[f] < f ? out_.row_of_facet[group_[f]] : write_facet(f);
    write_inner_parts();
    return std::move(out_);
  }

 private:
  struct EdgeUse {
    Edge edge;
    Index facet;  ///< no_index: a segment
  };

  bool may_merge(Index f) const {
    return f < parent_.size() && parent_[f] != no_index && plc_.n_loops(f) == 1 && plc_.outer_loop(f).size() == 3;
  }

  void collect_edges() {
    for (Index f = 0; f < plc_.n_facets(); ++f)
      for (Index l = plc_.facet_loops[f]; l < plc_.facet_loops[f + 1]; ++l) {
        const auto loop = plc_.loop(l);
        for (std::size_t i = 0; i < loop.size(); ++i)
          uses_.push_back({edge_of(loop[i], loop[(i + 1) % loop.size()]), f});
      }
    for (const auto& s : plc_.facet_segments) uses_.push_back({edge_of(s.a, s.b), no_index});
    for (const auto& s : plc_.segments) uses_.push_back({edge_of(s.a, s.b), no_index});
    std::sort(uses_.begin(), uses_.end(), [](const EdgeUse& a, const EdgeUse& b) {
      return a.edge != b.edge ? a.edge < b.edge : a.facet < b.facet;
    });
  }

  std::span<const EdgeUse> uses_of(const Edge& e) const {
    const auto range = std::equal_range(uses_.begin(), uses_.end(), EdgeUse{e, 0},
                                        [](const EdgeUse& a, const EdgeUse& b) { return a.edge < b.edge; });
    return {range.first, range.second};
  }

  /// The place of the edge (a, b) in the loop of a triangle; 3: none.
  std::size_t place_of(Index f, VertexIndex a, VertexIndex b) const {
    const auto t = plc_.outer_loop(f);
    std::size_t k = 0;
    while (k < 3 && (t[k] != a || t[(k + 1) % 3] != b)) ++k;
    return k;
  }

  /// Where nothing but two facets are at an edge, oriented alike, and both could be of one facet.
  void join_across_edges() {
    joined_.assign(plc_.n_facets(), {no_index, no_index, no_index});
    for (std::size_t i = 0, j; i < uses_.size(); i = j) {
      for (j = i; j < uses_.size() && uses_[j].edge == uses_[i].edge;) ++j;
      const Index f = uses_[i].facet, g = uses_[j - 1].facet;
      if (j - i != 2 || f == no_index || g == no_index || f == g || !may_merge(f) || !may_merge(g) ||
          parent_[f] != parent_[g])
        continue;
      const auto [a, b] = uses_[i].edge;
      const bool is_along = place_of(f, a, b) < 3;
      const std::size_t in_f = is_along ? place_of(f, a, b) : place_of(f, b, a),
                        in_g = is_along ? place_of(g, b, a) : place_of(g, a, b);
      if (in_g == 3) continue;
      joined_[f][in_f] = g;
      joined_[g][in_g] = f;
    }
  }

  Vec3 normal_of(Index f) const {
    const auto t = plc_.outer_loop(f);
    return cross(plc_.points[t[1]] - plc_.points[t[0]], plc_.points[t[2]] - plc_.points[t[0]]);
  }

  bool is_in_plane(Index f, const Vec3& origin, const Vec3& unit_normal, double ulps) const {
    const auto t = plc_.outer_loop(f);
    return dot(normal_of(f), unit_normal) > 0 && std::all_of(t.begin(), t.end(), [&](VertexIndex v) {
             return std::abs(dot(plc_.points[v] - origin, unit_normal)) <= ulps * ulp_;
           });
  }

  /// Weighted by area.
  bool are_in_mean_plane(const std::vector<Index>& members) const {
    Vec3 normal, middle;
    double weight = 0;
    const Vec3 origin = plc_.points[plc_.outer_loop(members[0])[0]];
    for (const Index f : members) {
      const auto t = plc_.outer_loop(f);
      const Vec3 n = normal_of(f);
      const double w = length(n);
      normal = normal + n;
      weight += w;
      for (const VertexIndex v : t) middle = middle + (w / 3) * (plc_.points[v] - origin);
    }
    normal = (1 / length(normal)) * normal;
    middle = origin + (1 / weight) * middle;
    return std::all_of(members.begin(), members.end(),
                       [&](Index f) { return is_in_plane(f, middle, normal, plane_ulps); });
  }

  /// From the largest facets, whose planes are known best.
  void grow_groups() {
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
      for (std::size_t k = 0; k < members.size(); ++k) {
        for (const Index g : joined_[members[k]]) {
          if (g == no_index || taken[g] || !is_in_plane(g, origin, normal, growing_ulps)) continue;
          taken[g] = true;
          members.push_back(g);
        }
      }
      if (members.size() > 1 && are_in_mean_plane(members)) keep_group(std::move(members), normal);
    }
  }

  /// Groups are known by their first facet.
  void keep_group(std::vector<Index> members, const Vec3& normal) {
    std::sort(members.begin(), members.end());
    for (const Index f : members) group_[f] = members.front();
    std::optional<Outline> outline = outline_of(members, normal);
    if (!outline) {
      for (const Index f : members) group_[f] = f;
      return;
    }
    outlines_.emplace(members.front(), std::move(*outline));
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
        open.insert(a);
        std::size_t n_own = 0;
        const auto uses = uses_of(edge_of(a, b));
        for (const EdgeUse& u : uses) n_own += u.facet != no_index && group_[u.facet] == group;
        if (n_own > 2) return std::nullopt;
        if (n_own == 1 && !next.emplace(a, b).second) return std::nullopt;
        if (n_own == 2 && uses.size() > 2 && seen.insert(edge_of(a, b)).second)
          outline.segments.push_back(edge_of(a, b));
      }
    }
    if (!trace(next, outline.loops)) return std::nullopt;
    put_outer_first(normal, outline.loops);
    for (const Loop& loop : outline.loops)
      for (const VertexIndex v : loop) open.erase(v);
    for (const Edge& e : outline.segments) open.erase(e[0]), open.erase(e[1]);
    for (const VertexIndex v : open)
      if (is_used_elsewhere(v, group)) outline.points.push_back(v);
    return outline;
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

  /// The outer loop is the only one that turns left about the normal.
  void put_outer_first(const Vec3& normal, std::vector<Loop>& loops) const {
    double most = -std::numeric_limits<double>::infinity();
    std::size_t outer = 0;
    for (std::size_t l = 0; l < loops.size(); ++l) {
      Vec3 sum;
      const Vec3& o = plc_.points[loops[l][0]];
      for (std::size_t i = 1; i + 1 < loops[l].size(); ++i)
        sum = sum + cross(plc_.points[loops[l][i]] - o, plc_.points[loops[l][i + 1]] - o);
      if (const double area = dot(sum, normal); area > most) most = area, outer = l;
    }
    std::swap(loops[0], loops[outer]);
  }

  /// Per vertex the facets that have it, and whether something else does.
  void count_uses() {
    used_by_others_.assign(plc_.points.size(), false);
    facets_at_.resize(plc_.points.size());
    for (const auto& s : plc_.facet_segments) used_by_others_[s.a] = used_by_others_[s.b] = true;
    for (const auto& s : plc_.segments) used_by_others_[s.a] = used_by_others_[s.b] = true;
    for (const auto& p : plc_.facet_points) used_by_others_[p.v] = true;
    for (const VertexIndex v : plc_.isolated_points) used_by_others_[v] = true;
    for (Index f = 0; f < plc_.n_facets(); ++f)
      for (Index l = plc_.facet_loops[f]; l < plc_.facet_loops[f + 1]; ++l)
        for (const VertexIndex v : plc_.loop(l)) facets_at_[v].push_back(f);
  }
  bool is_used_elsewhere(VertexIndex v, Index group) const {
    return used_by_others_[v] ||
           std::any_of(facets_at_[v].begin(), facets_at_[v].end(), [&](Index f) { return group_[f] != group; });
  }

  void copy_all_but_facets() {
    out_.plc.points = plc_.points;
    out_.plc.provenance_sets = plc_.provenance_sets;
    out_.plc.segments = plc_.segments;
    out_.plc.isolated_points = plc_.isolated_points;
    out_.plc.region_seeds = plc_.region_seeds;
    out_.plc.hole_seeds = plc_.hole_seeds;
  }

  /// The facet f, or the group whose first it is.
  Index write_facet(Index f) {
    const auto at = outlines_.find(f);
    if (at == outlines_.end()) {
      std::vector<Loop> loops;
      for (Index l = plc_.facet_loops[f]; l < plc_.facet_loops[f + 1]; ++l)
        loops.emplace_back(plc_.loop(l).begin(), plc_.loop(l).end());
      return out_.plc.add_polygon(loops, plc_.facet_provenance[f]);
    }
    const Index row = out_.plc.add_polygon(at->second.loops, plc_.facet_provenance[f]);
    for (const auto& [a, b] : at->second.segments) out_.plc.facet_segments.push_back({row, a, b});
    for (const VertexIndex v : at->second.points) out_.plc.facet_points.push_back({row, v});
    return row;
  }

  void write_inner_parts() {
    for (const auto& s : plc_.facet_segments) out_.plc.facet_segments.push_back({out_.row_of_facet[s.facet], s.a, s.b});
    for (const auto& p : plc_.facet_points) out_.plc.facet_points.push_back({out_.row_of_facet[p.facet], p.v});
  }

  const PiecewiseLinearComplex& plc_;
  std::span<const Index> parent_;
  double ulp_ = 0;            // of the largest coordinate, at most
  std::vector<Index> group_;  // by facet: the first facet of its group
  std::vector<EdgeUse> uses_;
  std::vector<std::array<Index, 3>> joined_;  // by facet, across the edges of its loop
  std::vector<std::vector<Index>> facets_at_;
  std::vector<bool> used_by_others_;
  std::map<Index, Outline> outlines_;
  MergedFacets out_;
};

}  // namespace

MergedFacets merge_pieces(const PiecewiseLinearComplex& plc, std::span<const Index> parent) {
  return PieceMerger(plc, parent).run();
}

}  // namespace geomesh::remesh
