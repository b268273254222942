// SPDX-License-Identifier: MIT
#include "delaunay/lane_kernels_body.hpp"

namespace geomesh::detail {
const LaneKernels baseline_kernels{walk, grow};
}  // namespace geomesh::detail
