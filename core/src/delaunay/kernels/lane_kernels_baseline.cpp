// SPDX-License-Identifier: MIT
// The lane kernels for any processor: lane_kernels_body.hpp compiled with the default instructions.
#include "delaunay/kernels/lane_kernels_body.hpp"

namespace geomesh::detail {
const LaneKernels baseline_kernels{walk, grow};
}  // namespace geomesh::detail
