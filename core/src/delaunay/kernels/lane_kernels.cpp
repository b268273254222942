// SPDX-License-Identifier: MIT
#include "delaunay/kernels/lane_kernels.hpp"

namespace geomesh {
const LaneKernels& lane_kernels() {
#if defined(GEOMESH_AVX2_KERNELS)
  if (__builtin_cpu_supports("avx2")) return detail::avx2_kernels;
#endif
  return detail::baseline_kernels;
}

}  // namespace geomesh
