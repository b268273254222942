// SPDX-License-Identifier: MIT
// The lane kernels for AVX2: lane_kernels_body.hpp compiled with AVX2 instructions.
#include "delaunay/kernels/lane_kernels_body.hpp"

namespace geomesh::detail {
const LaneKernels avx2_kernels{walk, grow};
}  // namespace geomesh::detail
