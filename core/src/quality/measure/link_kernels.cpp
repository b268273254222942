// SPDX-License-Identifier: MIT
#include "quality/measure/link_kernels.hpp"

namespace geomesh::remesh {

const LinkKernels& link_kernels() {
#if defined(GEOMESH_AVX2_KERNELS)
  if (__builtin_cpu_supports("avx2")) return detail::avx2_link_kernels;
#endif
  return detail::baseline_link_kernels;
}

}  // namespace geomesh::remesh
