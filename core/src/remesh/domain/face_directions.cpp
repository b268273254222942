// SPDX-License-Identifier: MIT
#include "remesh/domain/face_directions.hpp"

#include <algorithm>
#include <array>

#include "quality/measure/shape.hpp"

namespace geomesh::remesh {

namespace {

constexpr unsigned most_steps = 8;  ///< largest number of narrow faces to step across in search of a normal
/// Edges of at least this share of the longest count as longest: a needle has two of them, and either may be used.
constexpr double about_longest = 1 - 1e-6;

double longest_edge(const std::vector<Vec3>& points, const Triangle& t) {
  double longest = 0;
  for (unsigned k = 0; k < 3; ++k) longest = std::max(longest, distance(points[t[k]], points[t[(k + 1) % 3]]));
  return longest;
}

/// Returns the unit normal of a face, or zero if the face is narrow.
Vec3 own_direction(const std::vector<Vec3>& points, const Triangle& t, double narrow) {
  const Vec3 n = cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
  const double twice_area = length(n);
  return twice_area > narrow * longest_edge(points, t) ? (1 / twice_area) * n : Vec3{};
}

bool is_known(const Vec3& direction) { return dot(direction, direction) > 0; }

}  // namespace

bool runs_along(const Triangle& t, VertexIndex a, VertexIndex b) {
  for (unsigned i = 0; i < 3; ++i)
    if (t[i] == a && t[(i + 1) % 3] == b) return true;
  return false;
}

std::vector<Vec3> face_directions(const std::vector<Vec3>& points, std::span<const Triangle> faces,
                                  std::span<const Index> patch_of_face, std::span<const EdgeUse> uses, double narrow) {
  std::vector<Vec3> directions;
  for (const Triangle& t : faces) directions.push_back(own_direction(points, t, narrow));
  struct Beside {
    Index face, other;
    bool are_oriented_alike;
  };
  std::vector<Beside> narrow_beside;
  for (std::size_t i = 0, j; i < uses.size(); i = j) {
    for (j = i; j < uses.size() && uses[j].edge == uses[i].edge;) ++j;
    const auto [a, b] = uses[i].edge;
    if (j - i != 2 || patch_of_face[uses[i].face] != patch_of_face[uses[i + 1].face]) continue;
    for (const auto& [face, other] :
         {std::pair(uses[i].face, uses[i + 1].face), std::pair(uses[i + 1].face, uses[i].face)})
      if (!is_known(directions[face]) &&
          distance(points[a], points[b]) >= about_longest * longest_edge(points, faces[face]))
        narrow_beside.push_back({face, other, runs_along(faces[face], a, b) != runs_along(faces[other], a, b)});
  }
  for (unsigned step = 0; step < most_steps; ++step) {
    std::vector<Beside> left;
    for (const Beside& n : narrow_beside) {
      if (is_known(directions[n.face])) continue;
      if (is_known(directions[n.other]))
        directions[n.face] = (n.are_oriented_alike ? 1.0 : -1.0) * directions[n.other];
      else
        left.push_back(n);
    }
    narrow_beside.swap(left);
  }
  return directions;
}

}  // namespace geomesh::remesh
