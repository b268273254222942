// SPDX-License-Identifier: MIT
#include "quality/measure/link_kernels_body.hpp"

namespace geomesh::remesh::detail {
const LinkKernelTable baseline_link_kernels = QualityMeasures::table<LinkKernels, KernelsOf>();
}  // namespace geomesh::remesh::detail
