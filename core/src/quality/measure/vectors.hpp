// SPDX-License-Identifier: MIT
/// @file
/// The arithmetic of quality measures, written once for one cell (Real = double) and for several at a time (a vector of
/// lanes).
///
/// Every function is inlined into its caller at every level of optimisation, so that no version for one instruction set
/// can be linked into code for another.
#pragma once

#include <cmath>

#include "geomesh/core/geometry.hpp"

#define GEOMESH_INLINE [[gnu::always_inline]] inline

namespace geomesh::remesh {

/// Functions that the language provides only for doubles. Specialised for lanes in lanes.hpp.
template <class Real>
struct Arithmetic;

template <>
struct Arithmetic<double> {
  static constexpr bool is_scalar = true;
  GEOMESH_INLINE static double all(double x) { return x; }
  GEOMESH_INLINE static double root(double x) { return std::sqrt(x); }
};

template <class Real>
GEOMESH_INLINE Real all(double x) {
  return Arithmetic<Real>::all(x);
}
template <class Real>
GEOMESH_INLINE Real root(Real x) {
  return Arithmetic<Real>::root(x);
}
template <class Real>
GEOMESH_INLINE Real lesser(Real u, Real v) {
  return u < v ? u : v;
}

template <class Real>
struct Vectors {
  Real x, y, z;
};

template <class Real>
GEOMESH_INLINE Vectors<Real> plus(const Vectors<Real>& u, const Vectors<Real>& v) {
  return {u.x + v.x, u.y + v.y, u.z + v.z};
}
template <class Real>
GEOMESH_INLINE Vectors<Real> minus(const Vectors<Real>& u, const Vectors<Real>& v) {
  return {u.x - v.x, u.y - v.y, u.z - v.z};
}
template <class Real>
GEOMESH_INLINE Vectors<Real> times(Real s, const Vectors<Real>& v) {
  return {s * v.x, s * v.y, s * v.z};
}
template <class Real>
GEOMESH_INLINE Real product(const Vectors<Real>& u, const Vectors<Real>& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}
template <class Real>
GEOMESH_INLINE Vectors<Real> normal_to(const Vectors<Real>& u, const Vectors<Real>& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}
/// Selects lane by lane: u where the mask is set, v elsewhere.
template <class Mask, class Real>
GEOMESH_INLINE Vectors<Real> choose(const Mask& mask, const Vectors<Real>& u, const Vectors<Real>& v) {
  return {mask ? u.x : v.x, mask ? u.y : v.y, mask ? u.z : v.z};
}
template <class Real>
GEOMESH_INLINE Vectors<Real> place(const Vec3& p) {
  return {all<Real>(p.x), all<Real>(p.y), all<Real>(p.z)};
}

/// A face (a, b, c) with the values that all cells (a, b, c, p) over it share.
template <class Real>
struct Base {
  Vectors<Real> corner[3];
  Vectors<Real> normal;  ///< inward normal of the face, whose length is twice the face's area
  Real inverse;          ///< reciprocal of the squared length of the face's normal
  Real squared[3];       ///< squared lengths of the edges ab, bc, ca of the face (a, b, c)
};

template <class Real>
GEOMESH_INLINE Base<Real> base_of(const Vectors<Real>& a, const Vectors<Real>& b, const Vectors<Real>& c) {
  const Vectors<Real> u = minus(b, a), v = minus(c, b), w = minus(a, c), n = normal_to(u, minus(c, a));
  return {{a, b, c}, n, 1 / product(n, n), {product(u, u), product(v, v), product(w, w)}};
}

/// A cell as seen from its apex p: vectors to the corners of the base, outward normals of the faces at the apex (na is
/// on the face without a), six times the volume.
template <class Real>
struct Apex {
  Vectors<Real> a, b, c, na, nb, nc;
  Real det;
};

template <class Real>
GEOMESH_INLINE Apex<Real> apex_over(const Base<Real>& base, const Vectors<Real>& p) {
  const Vectors<Real> a = minus(base.corner[0], p), b = minus(base.corner[1], p), c = minus(base.corner[2], p);
  const Vectors<Real> na = normal_to(b, c);
  return {a, b, c, na, normal_to(c, a), normal_to(a, b), -product(a, na)};
}

}  // namespace geomesh::remesh
