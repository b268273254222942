// SPDX-License-Identifier: MIT
// The link kernels for any processor: link_kernels_body.hpp compiled with the default instructions.
#include "quality/measure/link_kernels_body.hpp"

namespace geomesh::remesh::detail {
const LinkKernelTable baseline_link_kernels = QualityMeasures::table<LinkKernels, KernelsOf>();
}  // namespace geomesh::remesh::detail
