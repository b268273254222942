// SPDX-License-Identifier: GPL-3.0-or-later
// Measures element shapes for the checker, declared in check/arrays/element_shape.hpp.
#include "check/arrays/element_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace geomesh::geomodel::checking {
namespace {

constexpr double degrees = 180 / std::numbers::pi;
/// Other programs may round the coordinates of corners differently, by at most this number of ulps.
constexpr double ulps_of_corners = 64;
/// Bound on the rounding error of sums of products of edge vectors, in the checker and in the mesher, as a multiple of
/// machine epsilon and relative to products of the longest edge. It matters for needles, whose faces and volumes are
/// much smaller than these products.
constexpr double epsilons_of_products = 32;
/// Relative difference that double arithmetic adds between two formulas for the same quantity.
constexpr double agreement = 1e-9;

double length_of(const Vec3& d) { return std::sqrt(dot(d, d)); }

/// The six edges of a tetrahedron: the two corners of each edge, followed by the two corners opposite to it.
constexpr std::array<std::array<int, 4>, 6> edges{
    {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}}};

/// Angle in degrees between the directions to `k` and to `l` after projecting both onto the plane normal to an edge.
double angle_at_edge(const Vec3& along, const Vec3& k, const Vec3& l) {
  const double square = dot(along, along);
  const Vec3 u = k - (dot(k, along) / square) * along, v = l - (dot(l, along) / square) * along;
  return std::atan2(length_of(cross(u, v)), dot(u, v)) * degrees;
}

/// Radius of the sphere through the origin, u, v and w. Its centre x solves x . p = |p|^2 / 2 for each p of u, v, w.
double circumradius(const Vec3& u, const Vec3& v, const Vec3& w, double six_volumes) {
  const Vec3 sum = dot(u, u) * cross(v, w) + dot(v, v) * cross(w, u) + dot(w, w) * cross(u, v);
  return length_of((0.5 / six_volumes) * sum);
}

}  // namespace

double ElementShape::slack_of_angles() const { return agreement * 180 + turn * degrees; }
double ElementShape::slack_of_ratios() const { return agreement + 4 * turn; }
double ElementShape::slack_of_lengths() const { return agreement * longest_edge + 4 * ulp; }

ElementShape element_shape(const std::array<Vec3, 4>& p, double ulp) {
  ElementShape s{};
  s.ulp = ulp;
  s.min_dihedral = 180;
  s.shortest_edge = std::numeric_limits<double>::infinity();
  double squares = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto [i, j, k, l] = edges[e];
    const Vec3 along = p[j] - p[i];
    s.dihedral[e] = angle_at_edge(along, p[k] - p[i], p[l] - p[i]);
    s.min_dihedral = std::min(s.min_dihedral, s.dihedral[e]);
    s.max_dihedral = std::max(s.max_dihedral, s.dihedral[e]);
    s.shortest_edge = std::min(s.shortest_edge, length_of(along));
    s.longest_edge = std::max(s.longest_edge, length_of(along));
    squares += dot(along, along);
  }
  const Vec3 u = p[1] - p[0], v = p[2] - p[0], w = p[3] - p[0];
  const double six_volumes = std::abs(dot(u, cross(v, w)));
  double area = 0, largest = 0, smallest = std::numeric_limits<double>::infinity();
  for (const double twice : {length_of(cross(u, v)), length_of(cross(v, w)), length_of(cross(w, u)),
                             length_of(cross(p[2] - p[1], p[3] - p[1]))}) {
    area += twice / 2;
    largest = std::max(largest, twice / 2);
    smallest = std::min(smallest, twice / 2);
  }
  const double of_products =
      epsilons_of_products * std::numeric_limits<double>::epsilon() * s.longest_edge * s.longest_edge;
  if (!(six_volumes > of_products * s.longest_edge && smallest > of_products)) {  // the element is too flat for doubles
    s.turn = std::numeric_limits<double>::infinity();
    return s;
  }
  const double least_height = six_volumes / (2 * largest);
  s.turn = ulps_of_corners * ulp / least_height + of_products * s.longest_edge / six_volumes + of_products / smallest;
  s.radius_ratio = 3 * (six_volumes / (2 * area)) / circumradius(u, v, w, six_volumes);
  s.aspect = least_height / (std::sqrt(2.0 / 3) * s.longest_edge);
  s.mean_ratio = 12 * std::cbrt(six_volumes * six_volumes / 4) / squares;
  return s;
}

ElementShape element_shape(const CheckedMesh& mesh, const Tetrahedron& cell, double ulp) {
  return element_shape({mesh.point(cell[0]), mesh.point(cell[1]), mesh.point(cell[2]), mesh.point(cell[3])}, ulp);
}

}  // namespace geomesh::geomodel::checking
