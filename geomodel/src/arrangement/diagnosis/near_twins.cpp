// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/diagnosis/near_twins.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geomesh/core/surface_distance.hpp"

namespace geomesh::geomodel::arrangement {

namespace {

constexpr double rounding_share = 32 * std::numeric_limits<double>::epsilon();  // of the greatest coordinate

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

class Twins {
 public:
  Twins(const std::vector<TriangulatedSurface>& surfaces, double distance)
      : surfaces_(surfaces), distance_(distance), searches_(surfaces.size()) {}

  /// Most of the vertices of one that are asked are within the distance of the other, and farther from it than
  /// rounding.
  bool follows(Index one, Index other) {
    const std::vector<Vec3>& points = surfaces_[one].points;
    const std::size_t step = points.size() / most_asked + 1, n = (points.size() + step - 1) / step;
    std::size_t n_beside = 0;
    for (std::size_t k = 0; k < n && 2 * (n_beside + n - k) > n; ++k) n_beside += is_beside(points[k * step], other);
    return 2 * n_beside > n;
  }

 private:
  static constexpr std::size_t most_asked = 256;

  bool is_beside(const Vec3& p, Index other) {
    std::optional<SurfaceDistance>& search = searches_[other];
    if (!search) search.emplace(surfaces_[other].points, surfaces_[other].triangles);
    const Vec3 way = search->closest(p) - p;
    const double d = std::sqrt(dot(way, way));
    return d <= distance_ && d > rounding_share * std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }

  const std::vector<TriangulatedSurface>& surfaces_;
  double distance_;
  std::vector<std::optional<SurfaceDistance>> searches_;
};

}  // namespace

std::vector<std::pair<Index, Index>> near_twins(const std::vector<TriangulatedSurface>& surfaces, double distance) {
  std::vector<Box3> boxes;
  for (const TriangulatedSurface& s : surfaces) boxes.push_back(box_of(s));
  Twins twins(surfaces, distance);
  std::vector<std::pair<Index, Index>> found;
  for (Index a = 0; a < surfaces.size(); ++a)
    for (Index b = a + 1; b < surfaces.size(); ++b) {
      if (surfaces[a].triangles.empty() || surfaces[b].triangles.empty() || !are_near(boxes[a], boxes[b], distance))
        continue;
      if (twins.follows(a, b) || twins.follows(b, a)) found.emplace_back(a, b);
    }
  return found;
}

}  // namespace geomesh::geomodel::arrangement
