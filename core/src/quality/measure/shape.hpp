// SPDX-License-Identifier: MIT
/// @file
/// The shape measure that improvement maximises, and its gradient.
///
/// The measure of a tetrahedron is the least sine of its six dihedral angles, the sines of obtuse angles weighted down
/// (Klingner and Shewchuk 2007, section 2, the "biased minimum sine"): here by sin 24.85 / sin 145, so that the two
/// bounds users ask for, 24.85 and 145 degrees, are one value of the measure. For a positive tetrahedron with 6V = det,
/// the sine at an edge e between the faces with normals m and n (of length twice the area) is det |e| / (|m| |n|).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "common/geometry.hpp"
#include "geomesh/core/geometry.hpp"

namespace geomesh::remesh {

/// sin(24.85 degrees) / sin(145 degrees).
inline constexpr double obtuse_weight = 0.73265;

/// That of the regular tetrahedron, whose least dihedral angle is the largest of all, and a little for rounding.
inline constexpr double largest_shape = 0.94281;

/// What a cell counts in a sum over many (MeanGoal): its shape, but below 12 degrees more, so that few slivers come for
/// the good of many.
inline constexpr double sliver_shape = 0.2079, sliver_weight = 3;

/// Value of the measure for an acute angle given in degrees.
inline double shape_of_angle(double degrees) { return std::sin(degrees * pi / 180); }

/// The six weighted sines of a tetrahedron (a, b, c, p), with what their gradients with respect to p need.
struct ShapeTerms {
  std::array<double, 6> value;  ///< edges pa, pb, pc, ab, bc, ca; all negative where the tetrahedron is not positive
  double worst() const { return *std::min_element(value.begin(), value.end()); }
};

namespace detail {

/// Edge vectors from the apex and normals: na, nb, nc outward on the faces at the apex, np inward on the base.
struct ShapeFrame {
  Vec3 A, B, C, na, nb, nc, np;
  double la, lb, lc, lp, det;
  ShapeFrame(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) : A(a - p), B(b - p), C(c - p) {
    na = cross(B, C);
    nb = cross(C, A);
    nc = cross(A, B);
    np = cross(b - a, c - a);
    la = length(na);
    lb = length(nb);
    lc = length(nc);
    lp = length(np);
    det = -dot(A, na);
  }
};

inline double weighted(double sine, double cosine) { return cosine < 0 ? obtuse_weight * sine : sine; }

}  // namespace detail

inline ShapeTerms shape_terms(const detail::ShapeFrame& f, const Vec3& a, const Vec3& b, const Vec3& c) {
  if (!(f.det > 0)) return {{f.det, f.det, f.det, f.det, f.det, -1e-300}};
  using detail::weighted;
  const double d = f.det;
  return {{weighted(d * length(f.A) / (f.lb * f.lc), -dot(f.nb, f.nc)),
           weighted(d * length(f.B) / (f.la * f.lc), -dot(f.na, f.nc)),
           weighted(d * length(f.C) / (f.la * f.lb), -dot(f.na, f.nb)),
           weighted(d * length(b - a) / (f.lc * f.lp), dot(f.nc, f.np)),
           weighted(d * length(c - b) / (f.la * f.lp), dot(f.na, f.np)),
           weighted(d * length(a - c) / (f.lb * f.lp), dot(f.nb, f.np))}};
}

/// A face with what all tetrahedra over it have in common: for many places of one apex.
struct ShapeBase {
  std::array<Vec3, 3> corner;
  Vec3 normal;                    ///< inward, of length twice the area
  double inverse;                 ///< of the normal's square
  std::array<double, 3> squared;  ///< lengths of the edges ab, bc, ca
  ShapeBase(const Vec3& a, const Vec3& b, const Vec3& c)
      : corner{a, b, c},
        normal(cross(b - a, c - a)),
        inverse(1 / dot(normal, normal)),
        squared{squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)} {}
};

/// The measure: in (0, 0.95] for positive tetrahedra, at most zero for others. As the least of shape_terms but for
/// rounding: squares are compared, so that one root is enough.
inline double shape(const ShapeBase& base, const Vec3& p) {
  const Vec3 a = base.corner[0] - p, b = base.corner[1] - p, c = base.corner[2] - p;
  const Vec3 na = cross(b, c), nb = cross(c, a), nc = cross(a, b);
  const double det = -dot(a, na);
  if (!(det > 0)) return det;
  const auto weighted = [](double square, double cosine) {
    return cosine < 0 ? obtuse_weight * obtuse_weight * square : square;
  };
  const double ia = 1 / dot(na, na), ib = 1 / dot(nb, nb), ic = 1 / dot(nc, nc), ip = base.inverse;
  const double pa = weighted(dot(a, a) * ib * ic, -dot(nb, nc)), pb = weighted(dot(b, b) * ia * ic, -dot(na, nc));
  const double pc = weighted(dot(c, c) * ia * ib, -dot(na, nb)),
               ab = weighted(base.squared[0] * ic * ip, dot(nc, base.normal));
  const double bc = weighted(base.squared[1] * ia * ip, dot(na, base.normal)),
               ca = weighted(base.squared[2] * ib * ip, dot(nb, base.normal));
  return det * std::sqrt(std::min({pa, pb, pc, ab, bc, ca}));
}
inline double shape(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) { return shape(ShapeBase(a, b, c), p); }

/// Gradient with respect to p of term k, whose value is given. Of log(sine): each factor contributes its own
/// logarithmic derivative.
inline Vec3 shape_gradient(const detail::ShapeFrame& f, unsigned k, double value) {
  const Vec3 area_a = (1 / (f.la * f.la)) * cross(f.B - f.C, f.na);
  const Vec3 area_b = (1 / (f.lb * f.lb)) * cross(f.C - f.A, f.nb);
  const Vec3 area_c = (1 / (f.lc * f.lc)) * cross(f.A - f.B, f.nc);
  Vec3 g = (1 / f.det) * f.np;
  switch (k) {
    case 0:
      g = g - (1 / dot(f.A, f.A)) * f.A - area_b - area_c;
      break;
    case 1:
      g = g - (1 / dot(f.B, f.B)) * f.B - area_a - area_c;
      break;
    case 2:
      g = g - (1 / dot(f.C, f.C)) * f.C - area_a - area_b;
      break;
    case 3:
      g = g - area_c;
      break;
    case 4:
      g = g - area_a;
      break;
    default:
      g = g - area_b;
      break;
  }
  return value * g;
}

}  // namespace geomesh::remesh
