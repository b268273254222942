// SPDX-License-Identifier: MIT
#include "plc/patch_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "delaunay/constrained_triangulation.hpp"

namespace geomesh {

namespace {

class PatchCrossings {
 public:
  PatchCrossings(std::span<const Vec3> points, std::span<const InnerEdge> edges, std::span<const Index> first)
      : points_(points), edges_(edges), first_(first), row_(points.size(), 0) {}

  bool exceed(std::size_t most) {
    std::vector<Bound> bounds;
    std::size_t left = 0, n = 0;
    for (Index patch = 0; patch + 1 < first_.size(); ++patch) {
      if (const auto flips = flips_to_delaunay(edges_of(patch))) {
        n += *flips;
        continue;
      }
      list_vertices(edges_of(patch));
      bounds.push_back({edges_of(patch).size() * most_crossed(vertices_.size()), patch});
      left += bounds.back().crossings;
    }
    std::sort(bounds.begin(), bounds.end(), [](const Bound& x, const Bound& y) {
      return x.crossings != y.crossings ? x.crossings > y.crossings : x.patch < y.patch;
    });
    for (const Bound& bound : bounds) {
      if (n > most || n + left <= most) break;
      left -= bound.crossings;
      n += crossings(edges_of(bound.patch), most - n);
    }
    return n > most;
  }

 private:
  struct Bound {
    std::size_t crossings;
    Index patch;
  };

  /// Returns the number of edges that are not locally Delaunay if one flip of each makes the patch Delaunay; otherwise
  /// nothing. Each of these edges then crosses exactly one edge of the Delaunay triangulation, so the patch need not be
  /// triangulated. Rounding only decides whether this is detected.
  std::optional<std::size_t> flips_to_delaunay(std::span<const InnerEdge> edges) const {
    std::size_t n = 0;
    for (const InnerEdge& e : edges) {
      if (is_locally_delaunay(e.a, e.b, e.apex, e.other_apex)) continue;
      for (const VertexIndex end : {e.a, e.b})
        for (const auto& [near, far] : {std::pair{e.apex, e.other_apex}, std::pair{e.other_apex, e.apex}})
          if (!is_locally_delaunay_after_flip(edges, end, near, end == e.a ? e.b : e.a, far)) return std::nullopt;
      ++n;
    }
    return n;
  }
  /// Flipping an edge replaces `apex` by `new_apex` at the side a-b of the edge's quadrilateral. Returns whether this
  /// side is locally Delaunay before and after the flip.
  bool is_locally_delaunay_after_flip(std::span<const InnerEdge> edges, VertexIndex a, VertexIndex b, VertexIndex apex,
                                      VertexIndex new_apex) const {
    const std::pair key{std::min(a, b), std::max(a, b)};
    const auto side = std::ranges::lower_bound(edges, key, {}, [](const InnerEdge& e) { return std::pair{e.a, e.b}; });
    if (side == edges.end() || side->a != key.first || side->b != key.second) return true;  // on the border
    const VertexIndex beyond = side->apex == apex ? side->other_apex : side->apex;
    return is_locally_delaunay(a, b, apex, beyond) && is_locally_delaunay(a, b, new_apex, beyond);
  }
  /// Returns whether the sum of the two angles opposite the edge a-b in its two triangles is at most 180 degrees.
  bool is_locally_delaunay(VertexIndex a, VertexIndex b, VertexIndex apex, VertexIndex other_apex) const {
    const auto sees = [&](VertexIndex from) {
      const Vec3 to_a = points_[a] - points_[from], to_b = points_[b] - points_[from];
      return Vec2{dot(to_a, to_b), length(cross(to_a, to_b))};
    };
    const Vec2 one = sees(apex), other = sees(other_apex);
    return one.x * other.y + one.y * other.x >= 0;
  }

  std::span<const InnerEdge> edges_of(Index patch) const {
    return edges_.subspan(first_[patch], first_[patch + 1] - first_[patch]);
  }

  void list_vertices(std::span<const InnerEdge> edges) {
    vertices_.clear();
    for (const InnerEdge& e : edges)
      for (const VertexIndex v : {e.a, e.b, e.apex, e.other_apex}) {
        if (row_[v] < vertices_.size() && vertices_[row_[v]] == v) continue;
        row_[v] = static_cast<VertexIndex>(vertices_.size());
        vertices_.push_back(v);
      }
  }

  /// Projects a polygon along the axis in which the normal of its largest triangle is longest.
  PlaneProjection projection(std::span<const InnerEdge> edges) const {
    Vec3 normal;
    for (const InnerEdge& e : edges)
      for (const VertexIndex apex : {e.apex, e.other_apex}) {
        const Vec3 n = triangle_normal(points_[e.a], points_[e.b], points_[apex]);
        if (squared_length(n) > squared_length(normal)) normal = n;
      }
    const double x = std::fabs(normal.x), y = std::fabs(normal.y), z = std::fabs(normal.z);
    PlaneProjection out;
    out.axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    return out;
  }

  /// Returns how many edges of the Delaunay triangulation the given edges cross, counted up to about `most`; 0 if the
  /// vertices have no Delaunay triangulation.
  std::size_t crossings(std::span<const InnerEdge> edges, std::size_t most) {
    list_vertices(edges);
    std::vector<Vec3> points;
    points.reserve(vertices_.size());
    for (const VertexIndex v : vertices_) points.push_back(points_[v]);
    ConstrainedTriangulation delaunay(points, projection(edges));
    if (!delaunay.triangulate()) return 0;
    std::size_t n = 0;
    for (const InnerEdge& e : edges) {
      if (n > most) break;
      n += delaunay.n_crossed(row_[e.a], row_[e.b], most - n + 1);
    }
    return n;
  }

  std::span<const Vec3> points_;
  std::span<const InnerEdge> edges_;
  std::span<const Index> first_;
  std::vector<VertexIndex> vertices_;  ///< vertices of the coplanar patch that is being triangulated
  std::vector<VertexIndex> row_;       ///< row of each point of the complex in vertices_; undefined for other patches
};

}  // namespace

bool are_far_from_delaunay(std::span<const Vec3> points, std::span<const InnerEdge> edges, std::span<const Index> first,
                           double most) {
  return PatchCrossings(points, edges, first)
      .exceed(static_cast<std::size_t>(most * static_cast<double>(edges.size())));
}

}  // namespace geomesh
