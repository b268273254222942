// SPDX-License-Identifier: MIT
/// @file
/// Four doubles in one vector, for the instruction set of the file that includes this header.
///
/// Lanes are IEEE doubles without contraction on every instruction set, so all versions compute the same bits.
#pragma once

#pragma GCC diagnostic ignored "-Wpsabi"  // all functions on vectors are inlined: no vector crosses a call

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "quality/measure/link_kernels.hpp"
#include "quality/measure/vectors.hpp"

namespace geomesh::remesh {

using Lanes = double __attribute__((vector_size(32)));
using StoredLanes = double __attribute__((vector_size(32), may_alias));
using Mask = long long __attribute__((vector_size(32)));
using Half = double __attribute__((vector_size(16)));

template <>
struct Arithmetic<Lanes> {
  static constexpr bool is_scalar = false;
  GEOMESH_INLINE static Lanes all(double x) { return Lanes{x, x, x, x}; }
  GEOMESH_INLINE static Lanes root(Lanes v) {
#if defined(__AVX__)
    return reinterpret_cast<Lanes>(_mm256_sqrt_pd(reinterpret_cast<__m256d>(v)));
#elif defined(__SSE2__)
    const Half low =
        reinterpret_cast<Half>(_mm_sqrt_pd(reinterpret_cast<__m128d>(__builtin_shufflevector(v, v, 0, 1))));
    const Half high =
        reinterpret_cast<Half>(_mm_sqrt_pd(reinterpret_cast<__m128d>(__builtin_shufflevector(v, v, 2, 3))));
    return __builtin_shufflevector(low, high, 0, 1, 2, 3);
#else
    return Lanes{__builtin_sqrt(v[0]), __builtin_sqrt(v[1]), __builtin_sqrt(v[2]), __builtin_sqrt(v[3])};
#endif
  }
};

GEOMESH_INLINE Lanes load(const FourFaces::Lanes& lanes) { return *reinterpret_cast<const StoredLanes*>(&lanes); }
GEOMESH_INLINE void store(Lanes v, FourFaces::Lanes& lanes) { *reinterpret_cast<StoredLanes*>(&lanes) = v; }
GEOMESH_INLINE Vectors<Lanes> load(const FourFaces::Lanes (&v)[3]) { return {load(v[0]), load(v[1]), load(v[2])}; }

GEOMESH_INLINE bool any(Mask m) {
#if defined(__AVX__)
  return _mm256_movemask_pd(reinterpret_cast<__m256d>(m)) != 0;
#else
  return ((m[0] | m[1]) | (m[2] | m[3])) != 0;
#endif
}

}  // namespace geomesh::remesh
