// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/framework/tetrahedron_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "geomesh/core/predicates.hpp"
#include "naming/sums.hpp"

namespace geomesh::geomodel {
namespace {

/// For each corner, the corners of the opposite face, in the orientation seen from inside a positive tetrahedron.
constexpr std::array<std::array<std::size_t, 3>, 4> face_of{{{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}}};
/// Largest number of planes of border faces that are tested. A box has six; with more, the search takes longer.
constexpr std::size_t most_planes = 64;
/// Bound on the rounding error of a point's offset along a plane's normal, relative to the largest coordinate: two sums
/// of three products with a unit vector.
constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();

/// Returns positive if p lies on the same side of a tetrahedron's face as the corner opposite to that face.
Sign side_of_face(const std::array<Vec3, 4>& t, std::size_t opposite, const Vec3& p) {
  const auto& [i, j, k] = face_of[opposite];
  return orient3d(t[i], t[j], t[k], p);
}

bool holds(const std::array<Vec3, 4>& t, const Vec3& p) {
  for (std::size_t i = 0; i < 4; ++i)
    if (side_of_face(t, i, p) == Sign::negative) return false;
  return true;
}

}  // namespace

TetrahedronSearch::TetrahedronSearch(std::vector<Vec3> points, std::vector<Tetrahedron> tetrahedra)
    : points_(std::move(points)), tetrahedra_(std::move(tetrahedra)) {
  find_neighbours();
  std::vector<Box3> boxes;
  for (Index t = 0; t < tetrahedra_.size(); ++t) {
    Box3& box = boxes.emplace_back();
    for (const Vec3& p : corners(t)) box.add(p);
  }
  tree_ = std::make_unique<arrangement::BoxTree>(boxes);
}

std::array<Vec3, 4> TetrahedronSearch::corners(Index t) const {
  const Tetrahedron& v = tetrahedra_[t];
  return {points_[v[0]], points_[v[1]], points_[v[2]], points_[v[3]]};
}

void TetrahedronSearch::find_neighbours() {
  struct Face {
    std::array<VertexIndex, 3> vertices;
    Index tetrahedron, opposite;
    bool operator<(const Face& other) const {
      return std::tie(vertices, tetrahedron) < std::tie(other.vertices, other.tetrahedron);
    }
  };
  std::vector<Face> faces;
  for (Index t = 0; t < tetrahedra_.size(); ++t)
    for (Index i = 0; i < 4; ++i) {
      const auto& [a, b, c] = face_of[i];
      std::array<VertexIndex, 3> v{tetrahedra_[t][a], tetrahedra_[t][b], tetrahedra_[t][c]};
      std::ranges::sort(v);
      faces.push_back({v, t, i});
    }
  std::sort(faces.begin(), faces.end());
  neighbour_.assign(tetrahedra_.size(), {no_index, no_index, no_index, no_index});
  std::vector<std::array<Index, 2>> border;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const Face& face = faces[k];
    if (k + 1 < faces.size() && faces[k + 1].vertices == face.vertices) {
      neighbour_[face.tetrahedron][face.opposite] = faces[k + 1].tetrahedron;
      neighbour_[faces[k + 1].tetrahedron][faces[k + 1].opposite] = face.tetrahedron;
      ++k;
    } else {
      border.push_back({face.tetrahedron, face.opposite});
    }
  }
  find_planes(border);
}

void TetrahedronSearch::find_planes(const std::vector<std::array<Index, 2>>& border) {
  std::vector<Plane> seen;
  double largest = 0;
  for (const Vec3& p : points_) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  for (const auto& [t, opposite] : border) {
    if (seen.size() == most_planes) return;
    const std::array<Vec3, 4> at = corners(t);
    const auto& [i, j, k] = face_of[opposite];
    Vec3 outward = cross(at[j] - at[i], at[k] - at[i]);
    if (!(norm(outward) > 0)) continue;
    outward = (1 / norm(outward)) * outward;
    if (dot(outward, at[opposite] - at[i]) > 0) outward = -1.0 * outward;
    const double offset = dot(outward, at[i]), off = rounding * largest;
    if (std::ranges::any_of(seen, [&](const Plane& plane) {
          return norm(plane.outward - outward) <= std::sqrt(rounding) && std::abs(plane.offset - offset) <= off;
        }))
      continue;
    seen.push_back({outward, offset});
    double farthest = offset;
    for (const Vec3& p : points_) farthest = std::max(farthest, dot(outward, p));
    if (farthest <= offset + off) planes_.push_back({outward, farthest + off});
  }
}

bool TetrahedronSearch::is_beyond_planes(const Vec3& p) const {
  return std::ranges::any_of(planes_, [&](const Plane& plane) { return dot(plane.outward, p) > plane.offset; });
}

Index TetrahedronSearch::find(const Vec3& p, Index start) const {
  if (tetrahedra_.empty() || is_beyond_planes(p)) return no_index;
  const Index found = walk(p, start == no_index ? 0 : start);
  return found == no_index ? search(p) : found;
}

Index TetrahedronSearch::walk(const Vec3& p, Index start) const {
  Index here = start, before = no_index;
  for (std::size_t step = 0; step < tetrahedra_.size(); ++step) {
    const std::array<Vec3, 4> t = corners(here);
    bool is_on_face = false, goes_on = false;
    for (std::size_t i = 0; i < 4 && !goes_on; ++i) {
      const Index next = neighbour_[here][i];
      if (next != no_index && next == before) continue;
      const Sign side = side_of_face(t, i, p);
      is_on_face = is_on_face || side == Sign::zero;
      if (side != Sign::negative) continue;
      if (next == no_index) return no_index;
      before = here;
      here = next;
      goes_on = true;
    }
    if (!goes_on) return is_on_face ? no_index : here;
  }
  return no_index;
}

Index TetrahedronSearch::search(const Vec3& p) const {
  Box3 place;
  place.add(p);
  Index found = no_index;
  tree_->boxes_meeting(place, [&](Index t) {
    if (t < found && holds(corners(t), p)) found = t;
  });
  return found;
}

}  // namespace geomesh::geomodel
