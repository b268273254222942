// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The checker's own exact arithmetic: signs of orientation and in-sphere determinants, and volumes, from coordinates
/// in doubles. A floating-point filter with a forward error bound decides the common case (bounds as in Shewchuk 1997,
/// "Adaptive precision floating-point arithmetic", section 4, rounded up); multi-word floats (CGAL::Mpzf, exact under
/// +, - and *) decide the rest. Independent of core/ on purpose.
#pragma once

#include <array>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel::checking {

/// Returns the sign of det[b-a, c-a, d-a]: positive for a tetrahedron in VTK order.
Sign orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Returns the sign of the area of a, b, c projected along `axis` (0: x, so onto y,z; 1: y, onto z,x; 2: z, onto x,y).
Sign projected_orientation(const Vec3& a, const Vec3& b, const Vec3& c, int axis);

/// Returns positive if e is strictly inside the sphere through the positively oriented a, b, c, d.
Sign in_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e);

/// Returns an axis along which the triangle has a projection of nonzero area, preferably the largest area in floating
/// point; -1 if the corners are collinear.
int projection_axis(const Vec3& a, const Vec3& b, const Vec3& c);

/// Returns the side of the line (along `axis`) through the centroid of (a,b,c), seen from the directed line u -> v in
/// the projection along `axis`; ties are broken by moving the centroid by an infinitesimal (e, e^2). The result is zero
/// only if u and v coincide in the projection.
Sign centroid_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& u, const Vec3& v, int axis);

/// Returns the sign of det[q-p, r-p, m-p] for the centroid m of (a,b,c).
Sign centroid_orientation(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& a, const Vec3& b, const Vec3& c);

/// Returns det[b-a, c-a, d-a], six times the tetrahedron's volume, with a relative error of 1e-12 despite cancellation.
double six_volumes(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
/// Returns cross(b-a, c-a), each component computed exactly and rounded once.
Vec3 exact_normal(const Vec3& a, const Vec3& b, const Vec3& c);

/// Sums volumes of tetrahedra exactly and rounds once at the end.
class ExactVolume {
 public:
  ExactVolume();
  ~ExactVolume();
  ExactVolume(ExactVolume&&) noexcept;
  ExactVolume& operator=(ExactVolume&&) noexcept;
  void add(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
  double value() const;

 private:
  struct Sum;
  Sum* sum_;
};

}  // namespace geomesh::geomodel::checking
