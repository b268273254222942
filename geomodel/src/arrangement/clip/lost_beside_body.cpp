// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/clip/lost_beside_body.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "geomesh/core/surface_distance.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

/// The body's triangles where they were given, turned as its shape is.
std::vector<Triangle> given_triangles(const TriangulatedSurface& body, const BodyShape& shape) {
  std::vector<Triangle> triangles = body.triangles;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (shape.orientation[t] < 0) std::swap(triangles[t][1], triangles[t][2]);
  return triangles;
}

/// Facets of the arrangement with their corners in doubles.
struct Facets {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
};

Facets facets_of(const Arranged& arranged, const std::vector<Index>& rows) {
  Facets facets;
  for (const Index f : rows) {
    const auto first = static_cast<VertexIndex>(facets.points.size());
    for (const VertexIndex v : arranged.facets[f]) facets.points.push_back(arranged.vertices.rounded(v));
    facets.triangles.push_back({first, first + 1, first + 2});
  }
  return facets;
}

/// Points on the edges of facets, no farther apart than `spacing` where edges are not very long.
std::vector<Vec3> points_on_edges(const Arranged& arranged, const std::vector<Index>& rows, double spacing) {
  constexpr double most_on_edge = 256;
  std::set<EdgeKey> edges;
  for (const Index f : rows)
    for (const EdgeKey& e : edges_of(arranged.facets[f])) edges.insert(e);
  std::vector<Vec3> points;
  for (const EdgeKey& e : edges) {
    const Vec3 a = arranged.vertices.rounded(e.first), b = arranged.vertices.rounded(e.second);
    const double n = std::ceil(std::clamp(length(b - a) / spacing, 1.0, most_on_edge));
    for (double k = 0; k <= n; ++k) points.push_back(a + (k / n) * (b - a));
  }
  return points;
}

double extent_of(const std::vector<Vec3>& points) {
  Box3 box;
  for (const Vec3& p : points) box.add(p);
  return length(box.max - box.min);
}

}  // namespace

Displacement lost_beside_body(const Arranged& arranged, const CutOff& cut, const TriangulatedSurface& body,
                              const BodyShape& shape, double tolerance) {
  constexpr double on_body = 1e-3, most_moves = 2;  // of the tolerance: the body, and what is brought to it
  const std::vector<Triangle> triangles = given_triangles(body, shape);
  const SurfaceDistance wall(body.points, triangles);
  const WindingNumber winding(body.points, triangles);
  const RayDirection ray = shape.closed ? RayDirection{} : *shape.open_direction;
  const std::vector<Vec3> gone = points_on_edges(arranged, cut.facets, tolerance);
  const Facets left = facets_of(arranged, cut.left);
  const SurfaceDistance rest(left.points, left.triangles);
  Displacement lost;
  for (const Vec3& p : gone) {
    const double from_wall = length(p - wall.closest(p));
    if (from_wall <= on_body * tolerance || from_wall > most_moves * tolerance) continue;
    const double far = rest.empty() ? extent_of(gone) : length(p - rest.closest(p));
    if (far <= lost.largest || winding(p, ray) != 0) continue;
    lost = {far, 0, p, 0};
  }
  return lost;
}

}  // namespace geomesh::geomodel::arrangement
