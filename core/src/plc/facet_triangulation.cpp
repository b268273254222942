// SPDX-License-Identifier: MIT
#include "plc/facet_triangulation.hpp"

#include <algorithm>
#include <cmath>

#include "common/geometry.hpp"
#include "common/sort_unique.hpp"
#include "delaunay/constrained_triangulation.hpp"
#include "geomesh/core/predicates.hpp"

namespace geomesh {

namespace {

/// Returns the projection along the largest component of the normal in which the outer loop is counter-clockwise.
PlaneProjection projection_along(const Vec3& normal) {
  using Handedness = PlaneProjection::Handedness;
  const double x = std::fabs(normal.x), y = std::fabs(normal.y), z = std::fabs(normal.z);
  const int axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  return {axis, normal[static_cast<std::size_t>(axis)] > 0 ? Handedness::right : Handedness::left};
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
    ConstrainedTriangulation plane = plane_of(normal);
    if (!plane.triangulate())
      return fail("the facet's vertices lie on one line or coincide in its plane", polygon_.loops[0]);
    for (const auto& loop : polygon_.loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        if (!constrain(plane, loop[i], loop[(i + 1) % loop.size()])) return std::nullopt;
    for (const auto& s : polygon_.segments)
      if (!constrain(plane, s[0], s[1])) return std::nullopt;
    plane.restore_delaunay();
    take_inside(plane);
    if (out_.triangles.empty()) return fail("the facet's outer loop does not turn around an area", polygon_.loops[0]);
    return out_;
  }

 private:
  using Edge = ConstrainedTriangulation::Edge;

  std::nullopt_t fail(const char* message, std::vector<VertexIndex> vertices) {
    fault_ = {message, std::move(vertices)};
    return std::nullopt;
  }
  VertexIndex local(VertexIndex v) const {
    return static_cast<VertexIndex>(std::lower_bound(vertices_.begin(), vertices_.end(), v) - vertices_.begin());
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
  /// Returns a triangulation of the points in space if they are exactly planar, with the same ties as in 3D, so that it
  /// equals the faces of a facet that is already in the mesh. Otherwise the projections of the points are triangulated.
  ConstrainedTriangulation plane_of(const Vec3& normal) const {
    const PlaneProjection projection = projection_along(normal);
    std::vector<Vec3> points;
    for (const VertexIndex v : vertices_) {
      points.push_back(points_[v]);
      if (out_.exactly_planar) continue;
      const Vec2 flat = projection(points_[v]);
      points.back() = {flat.x, flat.y, 0};
    }
    return ConstrainedTriangulation(points, out_.exactly_planar ? projection : PlaneProjection{});
  }
  bool constrain(ConstrainedTriangulation& plane, VertexIndex a, VertexIndex b) {
    const auto obstacle = plane.insert_constraint(local(a), local(b));
    if (!obstacle) return true;
    std::vector<VertexIndex> culprits{a, b};
    for (const VertexIndex v : *obstacle) culprits.push_back(vertices_[v]);
    fail(obstacle->size() == 1 ? "a vertex of the facet lies on one of its edges" : "two edges of the facet cross",
         culprits);
    return false;
  }
  /// Keeps the triangles inside the facet: those reached from the left of the outer loop without crossing any loop.
  void take_inside(const ConstrainedTriangulation& plane) {
    std::vector<Edge> sides;
    const auto add_sides = [&](const std::vector<VertexIndex>& loop) {
      for (std::size_t i = 0; i < loop.size(); ++i)
        sides.push_back({local(loop[i]), local(loop[(i + 1) % loop.size()])});
    };
    add_sides(polygon_.loops[0]);
    const std::vector<Edge> outer = sides;
    for (std::size_t l = 1; l < polygon_.loops.size(); ++l) add_sides(polygon_.loops[l]);
    for (const Triangle& t : plane.triangles_left_of(outer, sides))
      out_.triangles.push_back({vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]});
  }

  std::span<const Vec3> points_;
  const FacetPolygon& polygon_;
  FacetFault& fault_;
  std::vector<VertexIndex> vertices_;
  FacetTriangulation out_;
};

}  // namespace

std::optional<FacetTriangulation> triangulate_facet(std::span<const Vec3> points, const FacetPolygon& polygon,
                                                    FacetFault& fault) {
  return FacetTriangulator(points, polygon, fault).run();
}

}  // namespace geomesh
