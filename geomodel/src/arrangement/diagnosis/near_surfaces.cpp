// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/diagnosis/near_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geomesh/core/surface_distance.hpp"

namespace geomesh::geomodel::arrangement {

namespace {

// Fraction of the largest coordinate within which places coincide up to rounding.
constexpr double rounding_share = 32 * std::numeric_limits<double>::epsilon();

Box3 box_of(const TriangulatedSurface& surface) {
  Box3 box;
  for (const Vec3& p : surface.points) box.add(p);
  return box;
}

bool are_near(const Box3& a, const Box3& b, double distance) {
  for (std::size_t i = 0; i < 3; ++i)
    if (a.min[i] > b.max[i] + distance || b.min[i] > a.max[i] + distance) return false;
  return true;
}

using Edge = std::pair<VertexIndex, VertexIndex>;

/// Returns the border edges of a surface, those with one triangle.
std::vector<Edge> borders_of(const TriangulatedSurface& surface) {
  std::vector<Edge> edges, borders;
  for (const Triangle& t : surface.triangles)
    for (std::size_t k = 0; k < 3; ++k) edges.push_back(std::minmax(t[k], t[(k + 1) % 3]));
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0, j; i < edges.size(); i = j) {
    for (j = i; j < edges.size() && edges[j] == edges[i]; ++j) {
    }
    if (j - i == 1) borders.push_back(edges[i]);
  }
  return borders;
}

class Nearness {
 public:
  explicit Nearness(const std::vector<TriangulatedSurface>& surfaces)
      : surfaces_(surfaces), searches_(surfaces.size()), borders_(surfaces.size()) {}

  /// Returns whether most of the sampled vertices of one surface are within the distance of the other surface, but
  /// farther from it than rounding explains.
  bool follows(Index one, Index other, double distance) {
    const std::vector<Vec3>& points = surfaces_[one].points;
    const std::size_t step = points.size() / most_asked + 1, n = (points.size() + step - 1) / step;
    const auto is_beside = [&](const Vec3& p) {
      const double d = distance_between(p, other);
      return d <= distance && d > rounding_share * std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    };
    std::size_t n_beside = 0;
    for (std::size_t k = 0; k < n && 2 * (n_beside + n - k) > n; ++k) n_beside += is_beside(points[k * step]);
    return 2 * n_beside > n;
  }

  bool ends_beside(Index one, Index other, double distance) {
    if (surfaces_[one].kind != SurfaceKind::fault) return false;
    std::optional<std::vector<Edge>>& borders = borders_[one];
    if (!borders) borders = borders_of(surfaces_[one]);
    const std::vector<Vec3>& points = surfaces_[one].points;
    return std::any_of(borders->begin(), borders->end(), [&](const Edge& edge) {
      return distance_between(points[edge.first], other) <= distance &&
             distance_between(points[edge.second], other) <= distance;
    });
  }

 private:
  static constexpr std::size_t most_asked = 256;

  double distance_between(const Vec3& p, Index other) {
    std::optional<SurfaceDistance>& search = searches_[other];
    if (!search) search.emplace(surfaces_[other].points, surfaces_[other].triangles);
    const Vec3 way = search->closest(p) - p;
    return std::sqrt(dot(way, way));
  }

  const std::vector<TriangulatedSurface>& surfaces_;
  std::vector<std::optional<SurfaceDistance>> searches_;
  std::vector<std::optional<std::vector<Edge>>> borders_;
};

}  // namespace

NearSurfaces near_surfaces(const std::vector<TriangulatedSurface>& surfaces, double duplicate_distance,
                           double end_distance) {
  std::vector<Box3> boxes;
  for (const TriangulatedSurface& s : surfaces) boxes.push_back(box_of(s));
  Nearness nearness(surfaces);
  NearSurfaces found;
  for (Index a = 0; a < surfaces.size(); ++a)
    for (Index b = a + 1; b < surfaces.size(); ++b) {
      if (surfaces[a].triangles.empty() || surfaces[b].triangles.empty()) continue;
      if (!are_near(boxes[a], boxes[b], std::max(duplicate_distance, end_distance))) continue;
      if (nearness.follows(a, b, duplicate_distance) || nearness.follows(b, a, duplicate_distance))
        found.duplicates.emplace_back(a, b);
      if (nearness.ends_beside(a, b, end_distance) || nearness.ends_beside(b, a, end_distance))
        found.ending.emplace_back(a, b);
    }
  return found;
}

}  // namespace geomesh::geomodel::arrangement
