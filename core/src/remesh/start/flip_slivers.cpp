// SPDX-License-Identifier: MIT
#include "remesh/start/flip_slivers.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "common/geometry.hpp"
#include "remesh/domain/merge_pieces.hpp"

namespace geomesh::remesh {

namespace {

using Edge = std::array<VertexIndex, 2>;

class SliverFlipper {
 public:
  explicit SliverFlipper(PiecewiseLinearComplex& plc) : plc_(plc), is_plain_(plc.n_facets(), true) {
    for_each_side(plc, [&](Index f, VertexIndex a, VertexIndex b) { facets_at_[sorted(Edge{a, b})].push_back(f); });
    for (const auto& s : plc.segments) held_.insert(sorted(Edge{s.a, s.b}));
    for (const auto& s : plc.facet_segments) is_plain_[s.facet] = false;
    for (const auto& p : plc.facet_points) is_plain_[p.facet] = false;
    for (Index f = 0; f < plc.n_facets(); ++f)
      if (plc.n_loops(f) != 1 || plc.outer_loop(f).size() != 3) is_plain_[f] = false;
  }

  bool flip(Index f) {
    if (!is_plain_[f]) return false;
    const Triangle t = from_longest(triangle(f));
    const VertexIndex a = t[0], b = t[1], m = t[2];
    const std::vector<Index>& at = facets_at_[sorted(Edge{a, b})];
    if (at.size() != 2 || held_.contains(sorted(Edge{a, b}))) return false;
    const Index g = at[0] == f ? at[1] : at[0];
    if (g == f || !is_plain_[g] || plc_.facet_provenance[g] != plc_.facet_provenance[f]) return false;
    const Triangle other = triangle(g);
    const auto at_b = std::find(other.begin(), other.end(), b) - other.begin();
    if (other[(at_b + 1) % 3] != a) return false;  // the two triangles at the edge are oriented differently
    const VertexIndex q = other[(at_b + 2) % 3];
    const Triangle first{a, q, m}, second{q, b, m};
    const Vec3 up = normal(other);
    if (facets_at_.contains(sorted(Edge{m, q})) || !(dot(normal(first), up) > 0) || !(dot(normal(second), up) > 0))
      return false;
    exchange(f, g, t, q);
    set_triangle(f, first);
    set_triangle(g, second);
    return true;
  }

 private:
  Triangle triangle(Index f) const {
    const auto loop = plc_.outer_loop(f);
    return {loop[0], loop[1], loop[2]};
  }
  void set_triangle(Index f, const Triangle& t) {
    std::copy(t.begin(), t.end(), plc_.loop_vertices.begin() + plc_.loop_offsets[plc_.facet_loops[f]]);
  }
  Vec3 normal(const Triangle& t) const {
    return cross(plc_.points[t[1]] - plc_.points[t[0]], plc_.points[t[2]] - plc_.points[t[0]]);
  }
  /// Rotates the triangle so that its longest edge comes first.
  Triangle from_longest(Triangle t) const {
    const auto squared = [&](const Triangle& u) { return squared_distance(plc_.points[u[0]], plc_.points[u[1]]); };
    const Triangle second{t[1], t[2], t[0]}, third{t[2], t[0], t[1]};
    if (squared(second) > squared(t)) t = second;
    return squared(third) > squared(t) ? third : t;
  }
  /// Updates the facets at each edge for the flip of f = t and g = (t[1], t[0], q) to (t[0], q, t[2]), (q, t[1], t[2]).
  void exchange(Index f, Index g, const Triangle& t, VertexIndex q) {
    const auto replace = [&](VertexIndex a, VertexIndex b, Index from, Index to) {
      std::vector<Index>& at = facets_at_[sorted(Edge{a, b})];
      *std::find(at.begin(), at.end(), from) = to;
    };
    facets_at_.erase(sorted(Edge{t[0], t[1]}));
    replace(t[0], q, g, f);
    replace(t[1], t[2], f, g);
    facets_at_[sorted(Edge{t[2], q})] = {f, g};
  }

  PiecewiseLinearComplex& plc_;
  std::map<Edge, std::vector<Index>> facets_at_;
  std::set<Edge> held_;
  std::vector<bool> is_plain_;  // for each facet, whether it is a triangle with nothing inside
};

}  // namespace

std::vector<Index> flip_slivers(PiecewiseLinearComplex& plc, std::span<const Index> slivers) {
  SliverFlipper flipper(plc);
  std::vector<Index> left;
  for (const Index f : slivers)
    if (!flipper.flip(f)) left.push_back(f);
  return left;
}

}  // namespace geomesh::remesh
