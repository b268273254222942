// SPDX-License-Identifier: MIT
#include "plc/find_crossing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "common/parallel.hpp"
#include "geomesh/core/predicates.hpp"
#include "search/closest_point.hpp"

namespace geomesh {

namespace {

struct Item {
  Box3 box;
  VertexIndex a = no_vertex, b = no_vertex, c = no_vertex;  ///< corners of a triangle; an edge a-b has no c
  Index facet = no_index;
};

class CrossingSearch {
 public:
  explicit CrossingSearch(const PiecewiseLinearComplex& plc) : plc_(plc) {}

  /// Returns the crossings of the first edge that crosses any triangle.
  std::vector<PlcCrossing> first() {
    const search::ClosestPointTrees tree = prepare();
    std::vector<PlcCrossing> crossings;
    for (std::size_t k = 0; k < edges_.size() && crossings.empty(); ++k) append_of(edges_[k], tree, crossings);
    return crossings;
  }
  /// Returns all crossings of an edge with a triangle, sorted by edge, then by facet.
  std::vector<PlcCrossing> all(unsigned threads) {
    constexpr std::size_t chunk = 2048;
    const search::ClosestPointTrees tree = prepare();
    std::vector<std::vector<PlcCrossing>> found((edges_.size() + chunk - 1) / chunk);
    for_each_task(found.size(), threads, [&](std::size_t k) {
      for (std::size_t i = k * chunk; i < std::min(edges_.size(), (k + 1) * chunk); ++i)
        append_of(edges_[i], tree, found[k]);
    });
    std::vector<PlcCrossing> crossings;
    for (const auto& of_chunk : found) crossings.insert(crossings.end(), of_chunk.begin(), of_chunk.end());
    return crossings;
  }

 private:
  search::ClosestPointTrees prepare() {
    collect();
    sort_edges();
    return tree_of_triangles();
  }
  void append_of(const Item& e, const search::ClosestPointTrees& tree, std::vector<PlcCrossing>& crossings) const {
    const auto first = static_cast<std::ptrdiff_t>(crossings.size());
    tree.for_each_in(e.box, 0, [&](const auto& found) {
      const Item& t = triangles_[found.id];
      if (overlap(e.box, t.box) && meet(e, t)) crossings.push_back({e.a, e.b, e.facet, t.facet});
    });
    std::sort(crossings.begin() + first, crossings.end(),
              [](const PlcCrossing& x, const PlcCrossing& y) { return x.facet < y.facet; });
  }
  const Vec3& point(VertexIndex v) const { return plc_.points[v]; }

  Item make(VertexIndex a, VertexIndex b, VertexIndex c, Index facet) const {
    Item out{{}, a, b, c, facet};
    out.box.add(point(a));
    out.box.add(point(b));
    if (c != no_vertex) out.box.add(point(c));
    return out;
  }
  void collect() {
    // For each facet, whether it has points or segments inside. Other facets and segments may end at these.
    std::vector<bool> has_parts(plc_.n_facets(), false);
    for (const auto& p : plc_.facet_points) has_parts[p.facet] = true;
    for (const auto& s : plc_.facet_segments) has_parts[s.facet] = true;
    for (Index f = 0; f < plc_.n_facets(); ++f) {
      for (Index l = plc_.facet_loops[f]; l < plc_.facet_loops[f + 1]; ++l) {
        const auto loop = plc_.loop(l);
        for (std::size_t i = 0; i < loop.size(); ++i)
          edges_.push_back(make(loop[i], loop[(i + 1) % loop.size()], no_vertex, f));
      }
      const auto outer = plc_.outer_loop(f);
      if (plc_.n_loops(f) == 1 && outer.size() == 3 && !has_parts[f])
        triangles_.push_back(make(outer[0], outer[1], outer[2], f));
    }
    for (const auto& s : plc_.segments) edges_.push_back(make(s.a, s.b, no_vertex, no_index));
  }
  /// Sorts the edges along the longest axis and keeps only the first of equal edges.
  void sort_edges() {
    const std::size_t axis = longest_axis();
    const auto key = [axis](const Item& e) {
      return std::tuple(e.box.min[axis], std::min(e.a, e.b), std::max(e.a, e.b));
    };
    std::stable_sort(edges_.begin(), edges_.end(), [&](const Item& x, const Item& y) { return key(x) < key(y); });
    edges_.erase(
        std::unique(edges_.begin(), edges_.end(), [&](const Item& x, const Item& y) { return key(x) == key(y); }),
        edges_.end());
  }
  static bool overlap(const Box3& x, const Box3& y) {
    for (std::size_t i = 0; i < 3; ++i)
      if (x.min[i] > y.max[i] || y.min[i] > x.max[i]) return false;
    return true;
  }
  search::ClosestPointTrees tree_of_triangles() const {
    std::vector<search::ClosestPointTrees::Item> items;
    for (const Item& t : triangles_)
      items.push_back({{point(t.a), point(t.b), point(t.c)}, 0, static_cast<Index>(items.size())});
    return {std::move(items), 1};
  }
  std::size_t longest_axis() const {
    Box3 box;
    for (const Vec3& p : plc_.points) box.add(p);
    const Vec3 size = box.max - box.min;
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  }
  static bool has(const Item& t, VertexIndex v) { return v == t.a || v == t.b || v == t.c; }
  bool meet(const Item& e, const Item& t) const {
    const bool has_a = has(t, e.a), has_b = has(t, e.b);
    if (has_a && has_b) return false;
    const Sign sa = orient3d(point(t.a), point(t.b), point(t.c), point(e.a));
    const Sign sb = orient3d(point(t.a), point(t.b), point(t.c), point(e.b));
    if (sa == Sign::zero && sb == Sign::zero) return meet_in_plane(e, t, has_a, has_b);
    if (has_a || has_b || sa * sb == Sign::positive) return false;
    const Sign s0 = orient3d(point(e.a), point(e.b), point(t.a), point(t.b)),
               s1 = orient3d(point(e.a), point(e.b), point(t.b), point(t.c)),
               s2 = orient3d(point(e.a), point(e.b), point(t.c), point(t.a));
    const bool no_negative = s0 != Sign::negative && s1 != Sign::negative && s2 != Sign::negative;
    const bool no_positive = s0 != Sign::positive && s1 != Sign::positive && s2 != Sign::positive;
    return no_negative || no_positive;
  }
  bool meet_in_plane(const Item& e, const Item& t, bool has_a, bool has_b) const {
    const Vec3 n = cross(point(t.b) - point(t.a), point(t.c) - point(t.a));
    const unsigned axis = std::fabs(n.x) >= std::fabs(n.y) && std::fabs(n.x) >= std::fabs(n.z) ? 0
                          : std::fabs(n.y) >= std::fabs(n.z)                                   ? 1
                                                                                               : 2;
    const auto flat = [&](VertexIndex v) { return Vec2{point(v)[(axis + 1) % 3], point(v)[(axis + 2) % 3]}; };
    std::array<Vec2, 3> c{flat(t.a), flat(t.b), flat(t.c)};
    if (orient2d(c[0], c[1], c[2]) == Sign::negative) std::swap(c[1], c[2]);
    const Vec2 p = flat(e.a), q = flat(e.b);
    if ((!has_a && contains(c, p)) || (!has_b && contains(c, q))) return true;
    for (unsigned i = 0; i < 3; ++i) {
      const Vec2 &u = c[i], &v = c[(i + 1) % 3];
      if (u == p || u == q || v == p || v == q) continue;
      if (orient2d(p, q, u) * orient2d(p, q, v) == Sign::negative &&
          orient2d(u, v, p) * orient2d(u, v, q) == Sign::negative)
        return true;
    }
    return false;
  }
  static bool contains(const std::array<Vec2, 3>& c, const Vec2& p) {
    return orient2d(c[0], c[1], p) != Sign::negative && orient2d(c[1], c[2], p) != Sign::negative &&
           orient2d(c[2], c[0], p) != Sign::negative;
  }

  const PiecewiseLinearComplex& plc_;
  std::vector<Item> edges_, triangles_;
};

}  // namespace

std::optional<PlcCrossing> find_crossing(const PiecewiseLinearComplex& plc) {
  const std::vector<PlcCrossing> found = CrossingSearch(plc).first();
  return found.empty() ? std::nullopt : std::optional(found.front());
}

std::vector<PlcCrossing> find_crossings(const PiecewiseLinearComplex& plc, unsigned threads) {
  return CrossingSearch(plc).all(threads);
}

}  // namespace geomesh
