// SPDX-License-Identifier: MIT
#include "remesh/tolerance/flat_patches.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geomesh/core/predicates.hpp"
#include "quality/measure/shape.hpp"

namespace geomesh::remesh {

namespace {

/// Returns the ends of the chain that the pieces of a curve form, or nothing if they do not form one chain.
std::optional<std::array<Vec3, 2>> ends_of(const std::vector<CurvePiece>& pieces, Index curve) {
  std::array<Vec3, 2> ends;
  std::size_t n = 0;
  const auto times = [&](const Vec3& p) {
    std::size_t k = 0;
    for (const CurvePiece& c : pieces) k += c.curve == curve ? (c.a == p) + (c.b == p) : 0;
    return k;
  };
  for (const CurvePiece& c : pieces) {
    if (c.curve != curve) continue;
    for (const Vec3& p : {c.a, c.b}) {
      if (times(p) != 1) continue;
      if (n == 2) return std::nullopt;
      ends[n++] = p;
    }
  }
  return n == 2 ? std::optional(ends) : std::nullopt;
}

Vec3 area_vector(const std::array<Vec3, 3>& t) { return cross(t[1] - t[0], t[2] - t[0]); }

}  // namespace

std::array<Vec2, 3> seen_along(const Vec3& normal, const std::array<Vec3, 3>& corners) {
  const Vec3 n{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
  const int drop = n.x >= n.y && n.x >= n.z ? 0 : n.y >= n.z ? 1 : 2;
  const auto at = [&](const Vec3& p) {
    return drop == 0 ? Vec2{p.y, p.z} : drop == 1 ? Vec2{p.z, p.x} : Vec2{p.x, p.y};
  };
  return {at(corners[0]), at(corners[1]), at(corners[2])};
}

double signed_area(const std::array<Vec2, 3>& t) {
  return (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[1].y - t[0].y) * (t[2].x - t[0].x);
}

FlatPatches::FlatPatches(const search::TriangleSurfaces& original, Index n_patches, double rounding)
    : planes_(n_patches), rounding_(rounding) {
  std::vector<double> largest(n_patches, 0);
  for (const auto& item : original.pieces()) {
    const Vec3 n = area_vector(item.corners);
    if (const double area = length(n); area > largest[item.group]) {
      largest[item.group] = area;
      planes_[item.group] = {(1 / area) * n, item.corners[0]};
    }
  }
  std::vector<bool> is_flat(n_patches, true);
  for (const auto& item : original.pieces())
    if (!is_in_plane({item.corners, item.group})) is_flat[item.group] = false;
  for (Index p = 0; p < n_patches; ++p)
    if (!is_flat[p]) planes_[p] = {};
}

bool FlatPatches::is_in_plane(const SurfaceFace& f) const {
  const Plane& plane = planes_[f.patch];
  return std::ranges::all_of(f.corners,
                             [&](const Vec3& p) { return std::abs(dot(p - plane.point, plane.normal)) <= rounding_; });
}

bool FlatPatches::cover_the_same(const SurfacePart& before, const SurfacePart& after) const {
  return faces_cover_the_same(before.faces, after.faces) && are_straight_between_ends(before.curves, after.curves);
}

bool FlatPatches::faces_cover_the_same(const std::vector<SurfaceFace>& before,
                                       const std::vector<SurfaceFace>& after) const {
  const auto lies_flat = [&](const SurfaceFace& f) { return is_flat(f.patch) && is_in_plane(f); };
  if (!std::ranges::all_of(before, lies_flat) || !std::ranges::all_of(after, lies_flat)) return false;
  return std::ranges::all_of(after, [&](const SurfaceFace& f) {
    const Vec3& normal = planes_[f.patch].normal;
    double sum = 0;
    for (const SurfaceFace& g : before)
      if (g.patch == f.patch) sum += signed_area(seen_along(normal, g.corners));
    const auto [a, b, c] = seen_along(normal, f.corners);
    return sum != 0 && orient2d(a, b, c) == (sum > 0 ? Sign::positive : Sign::negative);
  });
}

/// Returns whether the removed pieces of each curve, and also the new ones, cover one straight line without overlap.
bool FlatPatches::are_straight_between_ends(const std::vector<CurvePiece>& before,
                                            const std::vector<CurvePiece>& after) const {
  const auto is_straight = [&](const CurvePiece& c) {
    const auto from = ends_of(before, c.curve), to = ends_of(after, c.curve);
    if (!from || !to || !std::is_permutation(from->begin(), from->end(), to->begin(), to->end())) return false;
    const Vec3 way = (*from)[1] - (*from)[0];
    const double reach = length(way);
    if (!(reach > 0)) return false;
    const auto is_on_line = [&](const Vec3& p) { return length(cross(p - (*from)[0], way)) <= rounding_ * reach; };
    const auto follow_the_line = [&](const std::vector<CurvePiece>& pieces) {
      double sum = 0;
      for (const CurvePiece& d : pieces)
        if (d.curve == c.curve) sum += std::abs(dot(d.b - d.a, way));
      return sum <= (reach + rounding_) * reach;
    };
    return is_on_line(c.a) && is_on_line(c.b) && follow_the_line(before) && follow_the_line(after);
  };
  return std::ranges::all_of(before, is_straight) && std::ranges::all_of(after, is_straight);
}

}  // namespace geomesh::remesh
