// SPDX-License-Identifier: MIT
/// @file
/// The list of all quality measures, and the definitions of those that are one smooth function of the apex.
///
/// A measure is a struct with the members of MeanRatioMeasure below. Its `value` and `gradient` are written once and
/// compiled for one cell and for four at a time. A further measure needs a struct here, a row of QualityMeasures, and
/// its name in geomesh/core/quality_measure.hpp.
#pragma once

#include "quality/measure/dihedral_measure.hpp"

namespace geomesh::remesh {

/// Returns the value of the measure for the sliver with the given least dihedral angle in degrees. The sliver is a
/// regular tetrahedron flattened along the line between the midpoints of two opposite edges. Slivers are the bad cells
/// of Delaunay meshes, so limits given as angles mean the same for all measures.
template <class Measure>
double value_of_sliver(double degrees);

/// The mean ratio 12 (3 volume)^(2/3) / (sum of squared edges) of Liu and Joe 1994 to the power 3/2. It orders cells as
/// the mean ratio does, is linear in the volume, and takes no cube root.
struct MeanRatioMeasure {
  static constexpr QualityMeasure id = QualityMeasure::mean_ratio;
  static constexpr double largest = 1 + 1e-9;  ///< the measure of the regular tetrahedron, enlarged for rounding
  static constexpr double poor = 0.1925;       ///< the measure of a sliver of 12 degrees; see CellQuality::worth

  static double of_angle(double degrees) { return value_of_sliver<MeanRatioMeasure>(degrees); }

  /// Returns the largest value of cells with a given dihedral angle. The best cell with this angle at an edge of length
  /// 2u is symmetric: its other vertices have the distance x from the edge's midpoint. Then 3 volume = u x^2 sin, and
  /// the sum of the squares is 8 u^2 + 4 x^2 q with q = 1 + sin^2(angle / 2). For u x^2 = 1 it is least if u^3 = q / 4.
  static double most_with_angle(double sine, double cosine) {
    return std::numbers::sqrt2 * sine / (1.5 - 0.5 * cosine);
  }

  /// Returns the mean ratio of a positive cell to the power 3/2.
  template <class Real>
  GEOMESH_INLINE static Real value(const Base<Real>& base, const Apex<Real>& t) {
    const Real s = sum_of_squares(base, t);
    return all<Real>(12 * std::numbers::sqrt3) * t.det / (s * root(s));
  }

  /// Returns the gradient of the measure with respect to the apex. `value` is the measure itself.
  template <class Real>
  GEOMESH_INLINE static Vectors<Real> gradient(const Base<Real>& base, const Apex<Real>& t, Real value) {
    const Vectors<Real> volume = times(1 / t.det, base.normal), edges = plus(plus(t.a, t.b), t.c);
    return times(value, plus(volume, times(3 / sum_of_squares(base, t), edges)));
  }

 private:
  template <class Real>
  GEOMESH_INLINE static Real sum_of_squares(const Base<Real>& base, const Apex<Real>& t) {
    const Real at_apex = product(t.a, t.a) + product(t.b, t.b) + product(t.c, t.c);
    return at_apex + (base.squared[0] + base.squared[1] + base.squared[2]);
  }
};

/// 3 * inscribed radius / circumscribed radius (Cavendish, Field and Frey 1985).
struct RadiusRatioMeasure {
  static constexpr QualityMeasure id = QualityMeasure::radius_ratio;
  static constexpr double largest = 1 + 1e-9;
  static constexpr double poor = 0.2211;

  static double of_angle(double degrees) { return value_of_sliver<RadiusRatioMeasure>(degrees); }

  /// Returns an upper bound that follows from radius ratio <= (mean ratio)^(3/4) (Liu and Joe 1994). It is not the
  /// least upper bound, but concave.
  static double most_with_angle(double sine, double cosine) {
    return std::sqrt(MeanRatioMeasure::most_with_angle(sine, cosine));
  }

  /// Returns the radius ratio. The inscribed radius is det / (sum of the lengths of the normals), the circumscribed
  /// radius is |centre| / (2 det).
  template <class Real>
  GEOMESH_INLINE static Real value(const Base<Real>& base, const Apex<Real>& t) {
    const Vectors<Real> n = centre(t);
    return all<Real>(6) * t.det * t.det / (sum_of_lengths(base, t) * root(product(n, n)));
  }

  template <class Real>
  GEOMESH_INLINE static Vectors<Real> gradient(const Base<Real>& base, const Apex<Real>& t, Real value) {
    const Vectors<Real> bc = minus(t.b, t.c), ca = minus(t.c, t.a), ab = minus(t.a, t.b), n = centre(t);
    const Vectors<Real> volume = times(2 / t.det, base.normal);
    const Vectors<Real> lengths = plus(plus(times(1 / root(product(t.na, t.na)), normal_to(bc, t.na)),
                                            times(1 / root(product(t.nb, t.nb)), normal_to(ca, t.nb))),
                                       times(1 / root(product(t.nc, t.nc)), normal_to(ab, t.nc)));
    const Vectors<Real> squares = plus(plus(times(product(t.a, t.a), normal_to(bc, n)),  //
                                            times(product(t.b, t.b), normal_to(ca, n))),
                                       times(product(t.c, t.c), normal_to(ab, n)));
    const Vectors<Real> normals =
        plus(plus(times(product(t.na, n), t.a), times(product(t.nb, n), t.b)), times(product(t.nc, n), t.c));
    const Vectors<Real> radius = times(1 / product(n, n), minus(squares, plus(normals, normals)));
    return times(value, minus(minus(volume, times(1 / sum_of_lengths(base, t), lengths)), radius));
  }

 private:
  /// Returns -2 det times the vector from the apex to the circumcentre, where det is six times the volume.
  template <class Real>
  GEOMESH_INLINE static Vectors<Real> centre(const Apex<Real>& t) {
    return plus(plus(times(product(t.a, t.a), t.na), times(product(t.b, t.b), t.nb)), times(product(t.c, t.c), t.nc));
  }
  template <class Real>
  GEOMESH_INLINE static Real sum_of_lengths(const Base<Real>& base, const Apex<Real>& t) {
    return root(product(t.na, t.na)) + root(product(t.nb, t.nb)) + root(product(t.nc, t.nc)) +
           root(product(base.normal, base.normal));
  }
};

/// Returns the value of the measure for positive cells, and six times the volume for others.
template <class Measure, class Real>
GEOMESH_INLINE Real shape_at(const Base<Real>& base, const Apex<Real>& t) {
  if constexpr (Arithmetic<Real>::is_scalar)
    if (!(t.det > 0)) return t.det;
  const Real value = Measure::value(base, t);
  return t.det > 0 ? value : t.det;
}
template <class Measure, class Real>
GEOMESH_INLINE Real shape_over(const Base<Real>& base, const Vectors<Real>& p) {
  return shape_at<Measure>(base, apex_over(base, p));
}
template <class Measure>
GEOMESH_INLINE double shape_of_cell(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  return shape_over<Measure>(base_of(place<double>(a), place<double>(b), place<double>(c)), place<double>(p));
}

template <class Measure>
double value_of_sliver(double degrees) {
  constexpr double cosine_of_regular = 1.0 / 3;
  const double cosine = std::max(std::cos(degrees * std::numbers::pi / 180), cosine_of_regular);
  // half the distance between two opposite edges of the sliver, which have length 1
  const double half = 0.25 * std::sqrt(1 / cosine - 1);
  return shape_of_cell<Measure>({-0.5, 0, -half}, {0.5, 0, -half}, {0, 0.5, half}, {0, -0.5, half});
}

template <class... Measures>
struct MeasureList {
  static constexpr std::size_t size = sizeof...(Measures);
  /// Collects Make<Measure>::entry of each measure in a table.
  template <class Entry, template <class> class Make>
  static constexpr std::array<Entry, size> table() {
    return {Make<Measures>::entry...};
  }
};

/// The quality measures in the order of the enumeration QualityMeasure.
using QualityMeasures = MeasureList<DihedralMeasure, RadiusRatioMeasure, MeanRatioMeasure>;
static_assert(QualityMeasures::size == n_quality_measures);

}  // namespace geomesh::remesh
