// SPDX-License-Identifier: MIT
#include "quality/measure/link_kernels.hpp"

namespace geomesh::remesh {

const LinkKernels& link_kernels(QualityMeasure measure) {
  const auto row = static_cast<std::size_t>(measure);
#if defined(GEOMESH_AVX2_KERNELS)
  if (__builtin_cpu_supports("avx2")) return detail::avx2_link_kernels[row];
#endif
  return detail::baseline_link_kernels[row];
}

}  // namespace geomesh::remesh
