// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/clip/lost_beside_body.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace geomesh::geomodel::arrangement {
namespace {

/// Returns the body's triangles in the consistent orientation of its BodyShape.
std::vector<Triangle> turned_triangles(const TriangulatedSurface& body, const BodyShape& shape) {
  std::vector<Triangle> triangles = body.triangles;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (shape.orientation[t] < 0) std::swap(triangles[t][1], triangles[t][2]);
  return triangles;
}

SurfaceDistance distance_to(const Arranged& arranged, const std::vector<Index>& rows) {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  for (const Index f : rows) {
    const auto first = static_cast<VertexIndex>(points.size());
    for (const VertexIndex v : arranged.facets[f]) points.push_back(arranged.vertices.rounded(v));
    triangles.push_back({first, first + 1, first + 2});
  }
  return {points, triangles};
}

std::set<EdgeKey> edges_of_facets(const Arranged& arranged, const std::vector<Index>& rows) {
  std::set<EdgeKey> edges;
  for (const Index f : rows)
    for (const EdgeKey& e : edges_of(arranged.facets[f])) edges.insert(e);
  return edges;
}

double extent_of(const Arranged& arranged, const std::vector<Index>& rows) {
  Box3 box;
  for (const Index f : rows)
    for (const VertexIndex v : arranged.facets[f]) box.add(arranged.vertices.rounded(v));
  return length(box.max - box.min);
}

}  // namespace

BodyAsGiven::BodyAsGiven(const TriangulatedSurface& body, const BodyShape& shape, double tolerance)
    : triangles_(turned_triangles(body, shape)),
      wall_(body.points, triangles_),
      winding_(body.points, triangles_),
      ray_(shape.closed ? RayDirection{} : *shape.open_direction),
      tolerance_(tolerance) {}

/// Visits sample points of an edge that are near the body's boundary but not on it. The step to the next sample grows
/// with the distance from the boundary.
template <typename Visit>
void BodyAsGiven::visit_beside(const Vec3& a, const Vec3& b, Visit&& visit) const {
  // Fractions of the tolerance: the distance within which a point counts as on the body, and the distance up to which
  // merging can have moved a point onto the body.
  constexpr double on_body = 1e-3, most_moves = 2;
  constexpr double most_on_edge = 256;
  const double total = length(b - a), least_step = std::max(tolerance_, total / most_on_edge);
  for (double at = 0;; at += least_step) {
    at = std::min(at, total);
    const Vec3 p = total > 0 ? a + (at / total) * (b - a) : a;
    const double from_wall = length(p - wall_.closest(p));
    if (from_wall > on_body * tolerance_ && from_wall <= most_moves * tolerance_) visit(p);
    if (at >= total) return;
    at += std::max(0.0, from_wall - most_moves * tolerance_ - least_step);
  }
}

Displacement BodyAsGiven::lost(const Arranged& arranged, const CutOff& cut) const {
  std::optional<SurfaceDistance> left;
  const auto distance_to_left = [&](const Vec3& p) {
    if (cut.left.empty()) return extent_of(arranged, cut.gone);
    if (!left) left.emplace(distance_to(arranged, cut.left));
    return length(p - left->closest(p));
  };
  Displacement lost;
  for (const EdgeKey& e : edges_of_facets(arranged, cut.gone))
    visit_beside(arranged.vertices.rounded(e.first), arranged.vertices.rounded(e.second), [&](const Vec3& p) {
      const double far = distance_to_left(p);
      if (far > lost.largest && winding_(p, ray_) == 0) lost = {far, 0, p, 0};
    });
  return lost;
}

}  // namespace geomesh::geomodel::arrangement
