// SPDX-License-Identifier: MIT
// The link kernels for AVX2: link_kernels_body.hpp compiled with AVX2 instructions.
#include "quality/measure/link_kernels_body.hpp"

namespace geomesh::remesh::detail {
const LinkKernelTable avx2_link_kernels = QualityMeasures::table<LinkKernels, KernelsOf>();
}  // namespace geomesh::remesh::detail
