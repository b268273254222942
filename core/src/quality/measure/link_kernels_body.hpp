// SPDX-License-Identifier: MIT
/// @file
/// Bodies of the link kernels, for every measure. Each link_kernels_*.cpp compiles them for one instruction set, with
/// internal linkage.
#pragma once

#include "quality/measure/cell_quality.hpp"
#include "quality/measure/lanes.hpp"  // must come before all other headers: it silences a warning about vectors
#include "quality/measure/measures.hpp"

namespace geomesh::remesh {
namespace {

GEOMESH_INLINE Base<Lanes> base_of(const FourFaces& f) {
  return {{load(f.corner[0]), load(f.corner[1]), load(f.corner[2])},
          load(f.normal),
          load(f.inverse),
          {load(f.squared[0]), load(f.squared[1]), load(f.squared[2])}};
}

template <class Measure>
GEOMESH_INLINE Lanes worths_of(Lanes shape) {
  return shape < Measure::poor ? all<Lanes>(poor_weight) * shape - all<Lanes>((poor_weight - 1) * Measure::poor)
                               : shape;
}

void prepare(FourFaces* faces, std::size_t n_fours) {
  for (std::size_t k = 0; k < n_fours; ++k) {
    FourFaces& f = faces[k];
    const Base<Lanes> base = base_of(load(f.corner[0]), load(f.corner[1]), load(f.corner[2]));
    store(base.normal.x, f.normal[0]), store(base.normal.y, f.normal[1]), store(base.normal.z, f.normal[2]);
    store(base.inverse, f.inverse);
    for (unsigned i = 0; i < 3; ++i) store(base.squared[i], f.squared[i]);
  }
}

template <class Measure>
void shapes(const FourFaces* faces, std::size_t n_fours, const Vec3& p, double* out) {
  const Vectors<Lanes> at = place<Lanes>(p);
  for (std::size_t k = 0; k < n_fours; ++k) {
    const Lanes four = shape_over<Measure>(base_of(faces[k]), at);
    __builtin_memcpy(out + 4 * k, &four, sizeof four);  // memcpy: `out` is aligned for single doubles, not for vectors
  }
}

template <class Measure>
double worst(const FourFaces* faces, std::size_t n_fours, const Vec3& p, double enough) {
  const Vectors<Lanes> at = place<Lanes>(p);
  Lanes least = all<Lanes>(1);
  for (std::size_t k = 0; k < n_fours; ++k) {
    least = lesser(shape_over<Measure>(base_of(faces[k]), at), least);
    if (any(least <= enough)) break;
  }
  const Lanes pairs = lesser<Lanes>(least, __builtin_shufflevector(least, least, 2, 3, 0, 1));
  return pairs[0] < pairs[1] ? pairs[0] : pairs[1];
}

template <class Measure>
double sum_of_worths(const FourFaces* faces, std::size_t n_fours, const Vec3& p, double floor) {
  const Vectors<Lanes> at = place<Lanes>(p);
  Lanes sum = all<Lanes>(0);
  for (std::size_t k = 0; k < n_fours; ++k) {
    const Lanes s = shape_over<Measure>(base_of(faces[k]), at);
    if (any(~(s > floor))) return -__builtin_inf();
    sum += load(faces[k].share) * worths_of<Measure>(s);
  }
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

template <class Measure>
Vec3 gradient_of_sum(const FourFaces* faces, std::size_t n_fours, const Vec3& p) {
  const Vectors<Lanes> at = place<Lanes>(p);
  Vectors<Lanes> sum = place<Lanes>({});
  for (std::size_t k = 0; k < n_fours; ++k) {
    const Base<Lanes> base = base_of(faces[k]);
    const Apex<Lanes> t = apex_over(base, at);
    const Lanes s = shape_at<Measure>(base, t);
    const Lanes slope = load(faces[k].share) * (s < Measure::poor ? all<Lanes>(poor_weight) : all<Lanes>(1));
    sum = plus(sum, times(slope, Measure::gradient(base, t, s)));
  }
  return Vec3{(sum.x[0] + sum.x[1]) + (sum.x[2] + sum.x[3]), (sum.y[0] + sum.y[1]) + (sum.y[2] + sum.y[3]),
              (sum.z[0] + sum.z[1]) + (sum.z[2] + sum.z[3])};
}

template <class Measure>
struct KernelsOf {
  static constexpr LinkKernels entry{prepare, shapes<Measure>, worst<Measure>, sum_of_worths<Measure>,
                                     gradient_of_sum<Measure>};
};

}  // namespace
}  // namespace geomesh::remesh
