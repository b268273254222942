// SPDX-License-Identifier: GPL-3.0-or-later
// Computes how often the border of a chart winds around a point, declared in arrangement/search/charts.hpp.
#include <algorithm>
#include <map>

#include "arrangement/search/bvh.hpp"
#include "arrangement/search/charts.hpp"
#include "geomesh/core/predicates.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

bool before(const Vec2& a, const Vec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

class Border {
 public:
  Border(const std::vector<Vec3>& points, std::size_t axis, const std::vector<BorderEdge>& edges)
      : points_(points), i_((axis + 1) % 3), j_((axis + 2) % 3), edges_(edges) {}

  bool winds_at_most_once() {
    if (!is_simple()) return false;
    list_ends();
    return alternates_everywhere() && n_outer_components() == 1;
  }

 private:
  /// One end of a border edge, at the vertex `at`; `is_out` if the edge leaves that vertex.
  struct End {
    VertexIndex at, other;
    bool is_out;
  };
  Vec2 flat(VertexIndex v) const { return {points_[v][i_], points_[v][j_]}; }

  /// Returns whether the edges of the chart's border, projected along an axis, meet only in shared vertices.
  bool is_simple() const {
    std::vector<Box3> boxes(edges_.size());
    for (std::size_t e = 0; e < edges_.size(); ++e)
      for (const VertexIndex v : {edges_[e].from, edges_[e].to}) boxes[e].add({flat(v).x, flat(v).y, 0});
    const BoxTree tree(boxes);
    bool simple = true;
    for (std::size_t leaf = 0; leaf < tree.n_leaves() && simple; ++leaf)
      tree.pairs_of_leaf(leaf, [&](Index a, Index b) { simple = simple && !meet(edges_[a], edges_[b]); });
    return simple;
  }

  /// Returns whether two edges meet except in a shared end. May also be true for collinear edges that are only near.
  bool meet(const BorderEdge& e, const BorderEdge& f) const {
    for (const auto& [s, p] : {std::pair{e.from, e.to}, std::pair{e.to, e.from}})
      for (const auto& [t, q] : {std::pair{f.from, f.to}, std::pair{f.to, f.from}})
        if (s == t) return overlap_from(flat(s), flat(p), flat(q));
    const Vec2 a = flat(e.from), b = flat(e.to), c = flat(f.from), d = flat(f.to);
    if (orient2d(a, b, c) * orient2d(a, b, d) == Sign::positive ||
        orient2d(c, d, a) * orient2d(c, d, b) == Sign::positive)
      return false;
    return std::max(std::min(a.x, b.x), std::min(c.x, d.x)) <= std::min(std::max(a.x, b.x), std::max(c.x, d.x)) &&
           std::max(std::min(a.y, b.y), std::min(c.y, d.y)) <= std::min(std::max(a.y, b.y), std::max(c.y, d.y));
  }

  /// Returns whether the segments from s to p and from s to q overlap.
  static bool overlap_from(const Vec2& s, const Vec2& p, const Vec2& q) {
    return orient2d(s, p, q) == Sign::zero && before(s, p) == before(s, q);
  }

  void list_ends() {
    for (const BorderEdge& e : edges_) {
      ends_.push_back({e.from, e.to, true});
      ends_.push_back({e.to, e.from, false});
    }
    std::sort(ends_.begin(), ends_.end(),
              [](const End& a, const End& b) { return std::tie(a.at, a.other) < std::tie(b.at, b.other); });
    for (std::size_t k = 0; k < ends_.size(); ++k)
      if (k == 0 || ends_[k].at != ends_[k - 1].at) begin_.push_back(k);
    begin_.push_back(ends_.size());
  }

  /// Returns whether the border edges around each vertex, ordered by angle, alternately leave and reach it: the winding
  /// numbers around the vertex are then two consecutive ones.
  bool alternates_everywhere() {
    for (std::size_t k = 0; k + 1 < begin_.size(); ++k) {
      const std::size_t n = begin_[k + 1] - begin_[k];
      if (n == 2 && ends_[begin_[k]].is_out != ends_[begin_[k] + 1].is_out) continue;
      sort_by_angle(begin_[k], begin_[k + 1]);
      for (std::size_t m = 0; m < n; ++m)
        if (ends_[begin_[k] + m].is_out == ends_[begin_[k] + (m + 1) % n].is_out) return false;
    }
    return true;
  }

  /// Sorts the edge ends at a vertex counter-clockwise, starting with the direction straight down.
  void sort_by_angle(std::size_t begin, std::size_t end) {
    const Vec2 s = flat(ends_[begin].at);
    std::sort(ends_.begin() + static_cast<std::ptrdiff_t>(begin), ends_.begin() + static_cast<std::ptrdiff_t>(end),
              [&](const End& a, const End& b) {
                const Vec2 p = flat(a.other), q = flat(b.other);
                const bool p_left = before(p, s), q_left = before(q, s);
                return p_left != q_left ? q_left : orient2d(s, p, q) == Sign::positive;
              });
  }

  /// Returns the number of connected parts of the chart's border that have the outside on the right of their edges. If
  /// there is only one such part, the others bound holes in it.
  std::size_t n_outer_components() {
    std::map<VertexIndex, VertexIndex> parent;
    const auto root = [&parent](VertexIndex v) {
      for (auto at = parent.try_emplace(v, v).first; at->second != v; at = parent.find(v))
        v = at->second = parent.at(at->second);
      return v;
    };
    for (const BorderEdge& e : edges_) {
      const VertexIndex a = root(e.from), b = root(e.to);
      parent[std::max(a, b)] = std::min(a, b);
    }
    // For each connected part of the chart's border: index in begin_ of its vertex least in projected coordinates.
    std::map<VertexIndex, std::size_t> first_of;
    for (std::size_t k = 0; k + 1 < begin_.size(); ++k) {
      const auto [at, is_new] = first_of.try_emplace(root(ends_[begin_[k]].at), k);
      if (!is_new && before(flat(ends_[begin_[k]].at), flat(ends_[begin_[at->second]].at))) at->second = k;
    }
    std::size_t n = 0;
    for (const auto& [component, k] : first_of) {
      sort_by_angle(begin_[k], begin_[k + 1]);
      n += ends_[begin_[k]].is_out;  // outside is below this vertex, so a leaving edge has it on its right
    }
    return n;
  }

  const std::vector<Vec3>& points_;
  std::size_t i_, j_;
  const std::vector<BorderEdge>& edges_;
  std::vector<End> ends_;           ///< by vertex
  std::vector<std::size_t> begin_;  ///< index in ends_ of the first border edge's end at each vertex
};

}  // namespace

bool winds_at_most_once(const std::vector<Vec3>& points, std::size_t axis, const std::vector<BorderEdge>& border) {
  return Border(points, axis, border).winds_at_most_once();
}

}  // namespace geomesh::geomodel::arrangement
