// SPDX-License-Identifier: MIT
#include "plc/facet_triangulation.hpp"

#include <algorithm>
#include <cmath>

#include "common/geometry.hpp"
#include "common/sort_unique.hpp"
#include "geomesh/core/predicates.hpp"
#include "plc/planar_triangulation.hpp"

namespace geomesh {

namespace {

/// Drops the coordinate in which the normal is largest; the outer loop turns left in what remains.
Vec2 project(const Vec3& p, const Vec3& normal) {
  const double x = std::fabs(normal.x), y = std::fabs(normal.y), z = std::fabs(normal.z);
  const unsigned axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  const double u = p[(axis + 1) % 3], v = p[(axis + 2) % 3];
  return normal[axis] > 0 ? Vec2{u, v} : Vec2{v, u};
}

class FacetTriangulator {
 public:
  FacetTriangulator(std::span<const Vec3> points, const FacetPolygon& polygon, FacetFault& fault)
      : points_(points), polygon_(polygon), fault_(fault) {}

  std::optional<FacetTriangulation> run() {
    collect_vertices();
    const Vec3 normal = loop_normal(points_, polygon_.loops[0]);
    if (normal == Vec3{}) return fail("the facet has no area", polygon_.loops[0]);
    measure_planarity(normal);
    std::vector<Vec2> projected;
    for (VertexIndex v : vertices_) projected.push_back(project(points_[v], normal));
    PlanarTriangulation plane(projected, circle_test(projected));
    if (!plane.triangulate())
      return fail("the facet's vertices lie on one line or coincide in its plane", polygon_.loops[0]);
    for (const auto& loop : polygon_.loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        if (!constrain(plane, loop[i], loop[(i + 1) % loop.size()])) return std::nullopt;
    mark_barriers();
    for (const auto& s : polygon_.segments)
      if (!constrain(plane, s[0], s[1])) return std::nullopt;
    plane.restore_delaunay();
    flood(plane);
    if (out_.triangles.empty()) return fail("the facet's outer loop does not turn around an area", polygon_.loops[0]);
    return out_;
  }

 private:
  using Edge = std::array<unsigned, 2>;

  std::nullopt_t fail(const char* message, std::vector<VertexIndex> vertices) {
    fault_ = {message, std::move(vertices)};
    return std::nullopt;
  }
  unsigned local(VertexIndex v) const {
    return static_cast<unsigned>(std::lower_bound(vertices_.begin(), vertices_.end(), v) - vertices_.begin());
  }
  void collect_vertices() {
    for (const auto& loop : polygon_.loops) vertices_.insert(vertices_.end(), loop.begin(), loop.end());
    for (const auto& s : polygon_.segments) vertices_.insert(vertices_.end(), s.begin(), s.end());
    vertices_.insert(vertices_.end(), polygon_.inner_points.begin(), polygon_.inner_points.end());
    sort_unique(vertices_);
  }
  void measure_planarity(const Vec3& normal) {
    std::array<VertexIndex, 3> base{vertices_[0], vertices_[0], vertices_[0]};
    base[1] = *std::find_if(vertices_.begin(), vertices_.end(),
                            [&](VertexIndex v) { return !(points_[v] == points_[base[0]]); });
    for (VertexIndex v : vertices_)
      if (!collinear(points_[base[0]], points_[base[1]], points_[v])) {
        base[2] = v;
        break;
      }
    out_.exactly_planar = std::all_of(vertices_.begin(), vertices_.end(), [&](VertexIndex v) {
      return orient3d(points_[base[0]], points_[base[1]], points_[base[2]], points_[v]) == Sign::zero;
    });
    if (out_.exactly_planar) return;
    const double size = length(normal);
    double low = 0, high = 0;
    for (VertexIndex v : vertices_) {
      const double h = dot(normal, points_[v] - points_[vertices_[0]]) / size;
      low = std::min(low, h);
      high = std::max(high, h);
    }
    out_.deviation = 0.5 * (high - low);
  }
  /// In an exactly planar facet the test of the space triangulation, so that a facet that is present equals its draft.
  PlanarTriangulation::CircleTest circle_test(const std::vector<Vec2>& projected) const {
    if (out_.exactly_planar)
      return [this](unsigned a, unsigned b, unsigned c, unsigned d) {
        return in_circle_coplanar_perturbed(points_[vertices_[a]], points_[vertices_[b]], points_[vertices_[c]],
                                            points_[vertices_[d]]) == Sign::positive;
      };
    return [&projected](unsigned a, unsigned b, unsigned c, unsigned d) {
      return in_circle_perturbed(projected[a], projected[b], projected[c], projected[d]) == Sign::positive;
    };
  }
  bool constrain(PlanarTriangulation& plane, VertexIndex a, VertexIndex b) {
    const auto obstacle = plane.insert_constraint(local(a), local(b));
    if (!obstacle) return true;
    std::vector<VertexIndex> culprits{a, b};
    for (unsigned v : *obstacle) culprits.push_back(vertices_[v]);
    fail(obstacle->size() == 1 ? "a vertex of the facet lies on one of its edges" : "two edges of the facet cross",
         culprits);
    return false;
  }
  void mark_barriers() {
    for (const auto& loop : polygon_.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const unsigned a = local(loop[i]), b = local(loop[(i + 1) % loop.size()]);
        barriers_.insert(a < b ? Edge{a, b} : Edge{b, a});
      }
  }
  /// From the left of the outer loop, not over any loop.
  void flood(const PlanarTriangulation& plane) {
    std::set<Edge> seen;
    std::vector<Edge> queue;
    const auto& outer = polygon_.loops[0];
    for (std::size_t i = 0; i < outer.size(); ++i)
      queue.push_back({local(outer[i]), local(outer[(i + 1) % outer.size()])});
    while (!queue.empty()) {
      const auto [a, b] = queue.back();
      queue.pop_back();
      const auto c = plane.apex(a, b);
      if (!c || seen.count({a, b})) continue;
      out_.triangles.push_back({vertices_[a], vertices_[b], vertices_[*c]});
      for (const Edge e : {Edge{a, b}, Edge{b, *c}, Edge{*c, a}}) {
        seen.insert(e);
        if (!barriers_.count(e[0] < e[1] ? e : Edge{e[1], e[0]})) queue.push_back({e[1], e[0]});
      }
    }
  }

  std::span<const Vec3> points_;
  const FacetPolygon& polygon_;
  FacetFault& fault_;
  std::vector<VertexIndex> vertices_;
  std::set<Edge> barriers_;
  FacetTriangulation out_;
};

}  // namespace

std::optional<FacetTriangulation> triangulate_facet(std::span<const Vec3> points, const FacetPolygon& polygon,
                                                    FacetFault& fault) {
  return FacetTriangulator(points, polygon, fault).run();
}

}  // namespace geomesh
