// SPDX-License-Identifier: MIT
#include "quality/measure/link_kernels_body.hpp"

namespace geomesh::remesh::detail {
const LinkKernels baseline_link_kernels{prepare, shapes, worst, sum_of_worths, gradient_of_sum};
}  // namespace geomesh::remesh::detail
