// SPDX-License-Identifier: MIT
/// @file
/// The quality measure by dihedral angles, which is the default of mesh improvement.
///
/// The measure of a tetrahedron is the least sine of its six dihedral angles, the sines of obtuse angles weighted down
/// (Klingner and Shewchuk 2007, section 2, the "biased minimum sine"). The weight is sin 24.85 / sin 145, so that the
/// two bounds that users want, 24.85 and 145 degrees, are one value of the measure. Let e be an edge of a positive
/// tetrahedron with det = 6 volume, between faces with normals m and n, of length twice the area. The sine at e is det
/// |e| / (|m| |n|).
#pragma once

#include <array>
#include <numbers>
#include <vector>

#include "geomesh/core/quality_measure.hpp"
#include "quality/measure/vectors.hpp"

namespace geomesh::remesh {

struct DihedralMeasure {
  static constexpr QualityMeasure id = QualityMeasure::dihedral;
  static constexpr double largest = 0.94281;  ///< the measure of the regular tetrahedron, enlarged for rounding
  static constexpr double poor = 0.2079;      ///< sine of the dihedral angle of 12 degrees; see CellQuality::worth
  static constexpr double obtuse_weight = 0.73265;  ///< sin(24.85 degrees) / sin(145 degrees)

  /// Returns the value of the measure for an acute angle in degrees.
  static double of_angle(double degrees) { return std::sin(degrees * std::numbers::pi / 180); }
  /// Returns a bound, concave in the angle, of the measure of cells with a dihedral angle <= 90 that has this sine.
  static double most_with_angle(double sine, double /*cosine*/) { return sine; }

  /// Returns the measure of a positive cell. Squares of sines are compared, so that one square root is enough.
  template <class Real>
  GEOMESH_INLINE static Real value(const Base<Real>& base, const Apex<Real>& t) {
    return t.det * root(Squares<Real>(base, t).least);
  }

  /// Returns the measure's gradient by the apex: the least sine times the sum of its factors' logarithmic derivatives.
  template <class Real>
  GEOMESH_INLINE static Vectors<Real> gradient(const Base<Real>& base, const Apex<Real>& t, Real value) {
    const Squares<Real> s(base, t);
    const Vectors<Real> area_a = times(s.ia, normal_to(minus(t.b, t.c), t.na));
    const Vectors<Real> area_b = times(s.ib, normal_to(minus(t.c, t.a), t.nb));
    const Vectors<Real> area_c = times(s.ic, normal_to(minus(t.a, t.b), t.nc));
    const auto is_pa = s.pa == s.least;
    const auto is_pb = (!is_pa) & (s.pb == s.least);
    const auto is_pc = (!is_pa) & (!is_pb) & (s.pc == s.least);
    const auto at_apex = is_pa | is_pb | is_pc;
    const auto is_ab = (!at_apex) & (s.ab == s.least);
    const auto is_bc = (!at_apex) & (!is_ab) & (s.bc == s.least);
    const auto is_ca = (!at_apex) & (!is_ab) & (!is_bc);
    const Vectors<Real> none = place<Real>({});
    const Vectors<Real> edge = choose(is_pa, t.a, choose(is_pb, t.b, t.c));
    Vectors<Real> g = times(1 / t.det, base.normal);
    g = minus(g, choose(at_apex, times(1 / product(edge, edge), edge), none));
    g = minus(g, choose(is_pb | is_pc | is_bc, area_a, none));
    g = minus(g, choose(is_pa | is_pc | is_ca, area_b, none));
    g = minus(g, choose(is_pa | is_pb | is_ab, area_c, none));
    return times(value, g);
  }

  /// Appends the gradients of all six weighted sines of the cell (a, b, c, p) that are at most `limit`.
  static void append_gradients(const std::array<Vec3, 3>& face, const Vec3& p, double limit, std::vector<Vec3>& out);

 private:
  /// The squares of the weighted sines at all edges, divided by the square of the determinant, and the least of them.
  template <class Real>
  struct Squares {
    Real ia, ib, ic, pa, pb, pc, ab, bc, ca, least;
    GEOMESH_INLINE Squares(const Base<Real>& base, const Apex<Real>& t)
        : ia(1 / product(t.na, t.na)),
          ib(1 / product(t.nb, t.nb)),
          ic(1 / product(t.nc, t.nc)),
          pa(weighted(product(t.a, t.a) * ib * ic, -product(t.nb, t.nc))),
          pb(weighted(product(t.b, t.b) * ia * ic, -product(t.na, t.nc))),
          pc(weighted(product(t.c, t.c) * ia * ib, -product(t.na, t.nb))),
          ab(weighted(base.squared[0] * ic * base.inverse, product(t.nc, base.normal))),
          bc(weighted(base.squared[1] * ia * base.inverse, product(t.na, base.normal))),
          ca(weighted(base.squared[2] * ib * base.inverse, product(t.nb, base.normal))),
          least(lesser(lesser(lesser(pa, pb), lesser(pc, ab)), lesser(bc, ca))) {}
    GEOMESH_INLINE static Real weighted(Real square, Real cosine) {
      return cosine < 0 ? all<Real>(obtuse_weight * obtuse_weight) * square : square;
    }
  };
};

}  // namespace geomesh::remesh
