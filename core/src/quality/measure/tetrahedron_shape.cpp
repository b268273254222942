// SPDX-License-Identifier: MIT
// Computes angles and ratios of one tetrahedron, declared in geomesh/core/quality.hpp.
#include <algorithm>
#include <cmath>

#include "common/geometry.hpp"
#include "geomesh/core/quality.hpp"
#include "geomesh/core/simplex_mesh.hpp"
#include "quality/measure/shape.hpp"

namespace geomesh {

namespace {

/// For each vertex of a tetrahedron, the positions in edge_vertices of its three edges.
constexpr std::array<std::array<std::uint8_t, 3>, 4> edges_at{{{0, 1, 2}, {0, 3, 4}, {1, 3, 5}, {2, 4, 5}}};

/// An angle from 0 to 180 degrees, given by its sine and cosine times a common length. Angles compare by their size.
struct Turned {
  double sine = 0, cosine = 0;
  bool is_less_than(const Turned& o) const { return o.sine * cosine > sine * o.cosine; }
  double degrees() const { return std::atan2(sine, cosine) * degrees_per_radian; }
};

/// Returns the inward normals of the faces, whose length is twice the area.
std::array<Vec3, 4> inward_normals(const std::array<Vec3, 4>& p) {
  std::array<Vec3, 4> n;
  for (unsigned i = 0; i < 4; ++i) {
    const auto& f = face_vertices[i];
    n[i] = cross(p[f[1]] - p[f[0]], p[f[2]] - p[f[0]]);
  }
  return n;
}

/// Computes the shape of the tetrahedron with corners p. `n` are inward_normals(p) or more accurate normals. The volume
/// is computed from the first corner.
TetrahedronShape shape_of(const std::array<Vec3, 4>& p, const std::array<Vec3, 4>& n) {
  TetrahedronShape s{};
  const Vec3 &a = p[0], &b = p[1], &c = p[2], &d = p[3];
  const double det = dot(cross(b - a, c - a), d - a);
  s.volume = det / 6;
  double area = 0, largest = 0;
  for (unsigned i = 0; i < 4; ++i) {
    area += length(n[i]) / 2;
    largest = std::max(largest, length(n[i]) / 2);
  }
  double squares = 0;
  s.shortest_edge = std::numeric_limits<double>::infinity();
  s.min_dihedral = 180;
  for (unsigned e = 0; e < 6; ++e) {
    const auto [i, j] = edge_vertices[e];
    const auto [k, l] = edge_vertices[5 - e];  // the two faces at edge i-j are opposite vertices k and l
    const double length = distance(p[i], p[j]);
    s.shortest_edge = std::min(s.shortest_edge, length);
    s.longest_edge = std::max(s.longest_edge, length);
    squares += length * length;
    // Computes the angle from its sine and cosine, both times the normals' lengths. Accurate for flat and sharp angles.
    s.dihedral[e] = std::atan2(det * length, -dot(n[k], n[l])) * degrees_per_radian;
    if (!(det > 0)) s.dihedral[e] = dot(n[k], n[l]) > 0 ? 180 : 0;
    s.min_dihedral = std::min(s.min_dihedral, s.dihedral[e]);
    s.max_dihedral = std::max(s.max_dihedral, s.dihedral[e]);
  }
  if (!(det > 0)) return s;
  for (unsigned i = 0; i < 4; ++i) {
    // Girard's theorem: the solid angle is the excess of the angles of a spherical triangle, which are the dihedral
    // angles at the three edges.
    const auto& [e, f, g] = edges_at[i];
    s.solid_angle[i] = std::max(0.0, s.dihedral[e] + s.dihedral[f] + s.dihedral[g] - 180);
  }
  const Vec3 u = b - a, v = c - a, w = d - a;
  const double circumradius =
      length(dot(u, u) * cross(v, w) + dot(v, v) * cross(w, u) + dot(w, w) * cross(u, v)) / (2 * det);
  s.radius_ratio = std::min(1.0, 3 * (3 * s.volume / area) / circumradius);
  s.aspect = (3 * s.volume / largest) / (s.longest_edge * std::sqrt(2.0 / 3.0));
  s.mean_ratio = 12 * std::cbrt(9 * s.volume * s.volume) / squares;
  return s;
}

}  // namespace

DihedralRange dihedral_range(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double det = dot(cross(b - a, c - a), d - a);
  const std::array<Vec3, 4> p{a, b, c, d}, n = inward_normals(p);
  if (!(det > 0)) {  // the tetrahedron is flat, inverted, or a needle whose volume is lost in rounding
    const TetrahedronShape s = shape_of(p, n);
    return {s.min_dihedral, s.max_dihedral};
  }
  Turned least, greatest;
  for (unsigned e = 0; e < 6; ++e) {
    const auto [i, j] = edge_vertices[e];
    const auto [k, l] = edge_vertices[5 - e];
    const Turned angle{det * distance(p[i], p[j]), -dot(n[k], n[l])};
    if (e == 0 || angle.is_less_than(least)) least = angle;
    if (e == 0 || greatest.is_less_than(angle)) greatest = angle;
  }
  return {least.degrees(), greatest.degrees()};
}

namespace {

/// Returns the position in edge_vertices of the edge between two corners of a tetrahedron.
unsigned edge_between(unsigned i, unsigned j) {
  unsigned e = 0;
  while (!(edge_vertices[e][0] == std::min(i, j) && edge_vertices[e][1] == std::max(i, j))) ++e;
  return e;
}

/// Returns the inward normals of the faces. Each is computed from the two shorter edges of its face, because products
/// of long edges would lose the area of a needle.
std::array<Vec3, 4> careful_normals(const std::array<Vec3, 4>& p) {
  std::array<Vec3, 4> n;
  for (unsigned i = 0; i < 4; ++i) {
    const auto& f = face_vertices[i];
    unsigned first = 0;  // corner of the face opposite the face's longest edge
    double longest = 0;
    for (unsigned k = 0; k < 3; ++k)
      if (const double edge = distance(p[f[(k + 1) % 3]], p[f[(k + 2) % 3]]); edge > longest) {
        longest = edge;
        first = k;
      }
    const Vec3 &o = p[f[first]], &q = p[f[(first + 1) % 3]], &r = p[f[(first + 2) % 3]];
    n[i] = cross(q - o, r - o);
  }
  return n;
}

/// Computes the shape of a tetrahedron of which some corners are much closer to each other than to the rest. The volume
/// is computed from the corner with the shortest edges.
TetrahedronShape shape_of_needle(const std::array<Vec3, 4>& p) {
  constexpr std::array<std::array<unsigned, 4>, 4> even_orders{
      {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}}};
  const auto reach = [&](unsigned i) {
    double sum = 0;
    for (const Vec3& q : p) sum += distance(p[i], q);
    return sum;
  };
  unsigned nearest = 0;
  for (unsigned i = 1; i < 4; ++i)
    if (reach(i) < reach(nearest)) nearest = i;
  const std::array<unsigned, 4>& order = even_orders[nearest];
  const std::array<Vec3, 4> turned{p[order[0]], p[order[1]], p[order[2]], p[order[3]]};
  const TetrahedronShape seen = shape_of(turned, careful_normals(turned));
  TetrahedronShape s = seen;
  for (unsigned e = 0; e < 6; ++e)
    s.dihedral[edge_between(order[edge_vertices[e][0]], order[edge_vertices[e][1]])] = seen.dihedral[e];
  for (unsigned i = 0; i < 4; ++i) s.solid_angle[order[i]] = seen.solid_angle[i];
  return s;
}

/// If six times the volume is below this share of the cube of the longest edge, rounding could decide its sign.
constexpr double needle_share = 1e-9;

}  // namespace

TetrahedronShape tetrahedron_shape(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const std::array<Vec3, 4> p{a, b, c, d};
  const TetrahedronShape s = shape_of(p, inward_normals(p));
  const double cube = s.longest_edge * s.longest_edge * s.longest_edge;
  return std::abs(6 * s.volume) > needle_share * cube ? s : shape_of_needle(p);
}

}  // namespace geomesh
