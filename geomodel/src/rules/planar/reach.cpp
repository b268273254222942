// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/planar/reach.hpp"

#include <algorithm>
#include <limits>

#include "naming/sums.hpp"

namespace geomesh::geomodel {
namespace {

constexpr unsigned most_halvings = 6;  // of a side

double distance_to(const EdgeEnds& edge, const Vec3& p) {
  const Vec3 d = edge[1] - edge[0];
  const double length = dot(d, d);
  const double t = length > 0 ? std::clamp(dot(p - edge[0], d) / length, 0.0, 1.0) : 0;
  return norm(p - (edge[0] + t * d));
}

double distance_to_nearest(const std::vector<EdgeEnds>& edges, const Vec3& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const EdgeEnds& edge : edges) nearest = std::min(nearest, distance_to(edge, p));
  return nearest;
}

struct Part {
  std::array<Vec3, 3> corners;
  unsigned halvings;
};

/// Returns whether all of a triangle is near one of the edges. Testing the corners suffices, because the set of points
/// within a distance of one edge is convex.
bool one_edge_is_near_all(const std::vector<EdgeEnds>& edges, const Part& part, double limit) {
  return std::ranges::any_of(edges, [&](const EdgeEnds& edge) {
    return std::ranges::all_of(part.corners, [&](const Vec3& p) { return distance_to(edge, p) <= limit; });
  });
}

}  // namespace

bool reaches_beyond(const std::array<Vec3, 3>& triangle, const std::vector<EdgeEnds>& edges, double limit) {
  std::vector<Part> open{{triangle, 0}};
  while (!open.empty()) {
    const Part part = open.back();
    open.pop_back();
    const auto& [a, b, c] = part.corners;
    const Vec3 middle = (1.0 / 3) * (a + b + c);
    const double off = distance_to_nearest(edges, middle);
    if (off > limit) return true;
    const double radius = std::max({norm(a - middle), norm(b - middle), norm(c - middle)});
    if (off + radius <= limit || one_edge_is_near_all(edges, part, limit)) continue;
    if (std::ranges::any_of(part.corners, [&](const Vec3& p) { return distance_to_nearest(edges, p) > limit; }) ||
        part.halvings == most_halvings)
      return true;
    const Vec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
    for (const std::array<Vec3, 3>& quarter :
         {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}, std::array{ab, bc, ca}})
      open.push_back({quarter, part.halvings + 1});
  }
  return false;
}

}  // namespace geomesh::geomodel
