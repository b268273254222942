// SPDX-License-Identifier: MIT
/// @file
/// Bodies of the link kernels; each link_kernels_*.cpp compiles them for one instruction set, with internal linkage.
/// Nothing here calls an inline function with external linkage, of which the linker might keep the version for the
/// wrong machine.
///
/// Lanes are IEEE doubles without contraction, whatever the registers, so all versions compute the same bits.
#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "quality/measure/link_kernels.hpp"
#include "quality/measure/shape.hpp"

#pragma GCC diagnostic ignored "-Wpsabi"  // all functions on vectors are inlined: no vector crosses a call

namespace geomesh::remesh {
namespace {

using Lanes = double __attribute__((vector_size(32), may_alias));
using Mask = long long __attribute__((vector_size(32), may_alias));
using Half = double __attribute__((vector_size(16), may_alias));

#define GEOMESH_INLINE [[gnu::always_inline]] inline

GEOMESH_INLINE Lanes load(const FourFaces::Lanes& lanes) { return *reinterpret_cast<const Lanes*>(&lanes); }
GEOMESH_INLINE void store(Lanes v, FourFaces::Lanes& lanes) { *reinterpret_cast<Lanes*>(&lanes) = v; }
GEOMESH_INLINE Lanes all(double x) { return Lanes{x, x, x, x}; }
GEOMESH_INLINE Lanes lesser(Lanes u, Lanes v) { return u < v ? u : v; }

GEOMESH_INLINE bool any(Mask m) {
#if defined(__AVX__)
  return _mm256_movemask_pd(reinterpret_cast<__m256d>(m)) != 0;
#else
  return ((m[0] | m[1]) | (m[2] | m[3])) != 0;
#endif
}

GEOMESH_INLINE Lanes root(Lanes v) {
#if defined(__AVX__)
  return reinterpret_cast<Lanes>(_mm256_sqrt_pd(reinterpret_cast<__m256d>(v)));
#elif defined(__SSE2__)
  const Half low = reinterpret_cast<Half>(_mm_sqrt_pd(reinterpret_cast<__m128d>(__builtin_shufflevector(v, v, 0, 1))));
  const Half high = reinterpret_cast<Half>(_mm_sqrt_pd(reinterpret_cast<__m128d>(__builtin_shufflevector(v, v, 2, 3))));
  return __builtin_shufflevector(low, high, 0, 1, 2, 3);
#else
  return Lanes{__builtin_sqrt(v[0]), __builtin_sqrt(v[1]), __builtin_sqrt(v[2]), __builtin_sqrt(v[3])};
#endif
}

struct Vectors {
  Lanes x, y, z;
};
GEOMESH_INLINE Vectors minus(const Vectors& u, const Vectors& v) { return {u.x - v.x, u.y - v.y, u.z - v.z}; }
GEOMESH_INLINE Vectors times(Lanes s, const Vectors& v) { return {s * v.x, s * v.y, s * v.z}; }
GEOMESH_INLINE Lanes product(const Vectors& u, const Vectors& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
GEOMESH_INLINE Vectors normal_to(const Vectors& u, const Vectors& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}
GEOMESH_INLINE Vectors choose(Mask m, const Vectors& u, const Vectors& v) {
  return {m ? u.x : v.x, m ? u.y : v.y, m ? u.z : v.z};
}
GEOMESH_INLINE Vectors load(const FourFaces::Lanes (&v)[3]) { return {load(v[0]), load(v[1]), load(v[2])}; }

/// Squares of the weighted sines over the determinant's; see `shape`.
struct Cells {
  Vectors a, b, c, na, nb, nc;
  Lanes ia, ib, ic, det, pa, pb, pc, ab, bc, ca, least;
};

GEOMESH_INLINE Lanes weighted(Lanes square, Lanes cosine) {
  return cosine < 0 ? all(obtuse_weight * obtuse_weight) * square : square;
}

GEOMESH_INLINE Cells cells_over(const FourFaces& f, const Vectors& p) {
  Cells t;
  t.a = minus(load(f.corner[0]), p), t.b = minus(load(f.corner[1]), p), t.c = minus(load(f.corner[2]), p);
  t.na = normal_to(t.b, t.c), t.nb = normal_to(t.c, t.a), t.nc = normal_to(t.a, t.b);
  t.det = -product(t.a, t.na);
  t.ia = 1 / product(t.na, t.na), t.ib = 1 / product(t.nb, t.nb), t.ic = 1 / product(t.nc, t.nc);
  const Lanes ip = load(f.inverse);
  const Vectors np = load(f.normal);
  t.pa = weighted(product(t.a, t.a) * t.ib * t.ic, -product(t.nb, t.nc));
  t.pb = weighted(product(t.b, t.b) * t.ia * t.ic, -product(t.na, t.nc));
  t.pc = weighted(product(t.c, t.c) * t.ia * t.ib, -product(t.na, t.nb));
  t.ab = weighted(load(f.squared[0]) * t.ic * ip, product(t.nc, np));
  t.bc = weighted(load(f.squared[1]) * t.ia * ip, product(t.na, np));
  t.ca = weighted(load(f.squared[2]) * t.ib * ip, product(t.nb, np));
  t.least = lesser(lesser(lesser(t.pa, t.pb), lesser(t.pc, t.ab)), lesser(t.bc, t.ca));
  return t;
}

GEOMESH_INLINE Lanes shapes_of(const Cells& t) { return t.det > 0 ? t.det * root(t.least) : t.det; }
GEOMESH_INLINE Vectors place(const Vec3& p) { return {all(p.x), all(p.y), all(p.z)}; }

GEOMESH_INLINE Lanes worths_of(Lanes shape) {
  return shape < sliver_shape ? all(sliver_weight) * shape - all((sliver_weight - 1) * sliver_shape) : shape;
}

void prepare(FourFaces* faces, std::size_t n_fours) {
  for (std::size_t k = 0; k < n_fours; ++k) {
    FourFaces& f = faces[k];
    const Vectors a = load(f.corner[0]), b = load(f.corner[1]), c = load(f.corner[2]);
    const Vectors u = minus(b, a), v = minus(c, b), w = minus(a, c), n = normal_to(u, minus(c, a));
    store(n.x, f.normal[0]), store(n.y, f.normal[1]), store(n.z, f.normal[2]);
    store(1 / product(n, n), f.inverse);
    store(product(u, u), f.squared[0]), store(product(v, v), f.squared[1]), store(product(w, w), f.squared[2]);
  }
}

void shapes(const FourFaces* faces, std::size_t n_fours, const Vec3& p, double* out) {
  using Unaligned = double __attribute__((vector_size(32), aligned(8), may_alias));
  const Vectors at = place(p);
  for (std::size_t k = 0; k < n_fours; ++k)
    *reinterpret_cast<Unaligned*>(out + 4 * k) = shapes_of(cells_over(faces[k], at));
}

double worst(const FourFaces* faces, std::size_t n_fours, const Vec3& p, double enough) {
  const Vectors at = place(p);
  Lanes least = all(1);
  for (std::size_t k = 0; k < n_fours; ++k) {
    least = lesser(shapes_of(cells_over(faces[k], at)), least);
    if (any(least <= enough)) break;
  }
  const Lanes pairs = lesser(least, __builtin_shufflevector(least, least, 2, 3, 0, 1));
  return pairs[0] < pairs[1] ? pairs[0] : pairs[1];
}

double sum_of_worths(const FourFaces* faces, std::size_t n_fours, const Vec3& p, double floor) {
  const Vectors at = place(p);
  Lanes sum = all(0);
  for (std::size_t k = 0; k < n_fours; ++k) {
    const Lanes s = shapes_of(cells_over(faces[k], at));
    if (any(~(s > floor))) return -__builtin_inf();
    sum += load(faces[k].share) * worths_of(s);
  }
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

/// Of the shapes, by their least term: each of its factors contributes its own logarithmic derivative.
GEOMESH_INLINE Vectors gradients_of(const FourFaces& f, const Cells& t) {
  const Vectors area_a = times(t.ia, normal_to(minus(t.b, t.c), t.na));
  const Vectors area_b = times(t.ib, normal_to(minus(t.c, t.a), t.nb));
  const Vectors area_c = times(t.ic, normal_to(minus(t.a, t.b), t.nc));
  const Mask is_pa = t.pa == t.least, is_pb = ~is_pa & (t.pb == t.least), is_pc = ~is_pa & ~is_pb & (t.pc == t.least);
  const Mask at_apex = is_pa | is_pb | is_pc;
  const Mask is_ab = ~at_apex & (t.ab == t.least), is_bc = ~at_apex & ~is_ab & (t.bc == t.least),
             is_ca = ~at_apex & ~is_ab & ~is_bc;
  const Vectors none{all(0), all(0), all(0)};
  Vectors g = times(1 / t.det, load(f.normal));
  const Vectors edge = choose(is_pa, t.a, choose(is_pb, t.b, t.c));
  g = minus(g, choose(at_apex, times(1 / product(edge, edge), edge), none));
  g = minus(g, choose(is_pb | is_pc | is_bc, area_a, none));
  g = minus(g, choose(is_pa | is_pc | is_ca, area_b, none));
  g = minus(g, choose(is_pa | is_pb | is_ab, area_c, none));
  return times(shapes_of(t), g);
}

Vec3 gradient_of_sum(const FourFaces* faces, std::size_t n_fours, const Vec3& p) {
  const Vectors at = place(p);
  Vectors sum{all(0), all(0), all(0)};
  for (std::size_t k = 0; k < n_fours; ++k) {
    const Cells t = cells_over(faces[k], at);
    const Lanes slope = load(faces[k].share) * (shapes_of(t) < sliver_shape ? all(sliver_weight) : all(1));
    const Vectors g = times(slope, gradients_of(faces[k], t));
    sum = {sum.x + g.x, sum.y + g.y, sum.z + g.z};
  }
  return Vec3{(sum.x[0] + sum.x[1]) + (sum.x[2] + sum.x[3]), (sum.y[0] + sum.y[1]) + (sum.y[2] + sum.y[3]),
              (sum.z[0] + sum.z[1]) + (sum.z[2] + sum.z[3])};
}

}  // namespace
}  // namespace geomesh::remesh
