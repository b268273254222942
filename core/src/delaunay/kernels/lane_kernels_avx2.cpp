// SPDX-License-Identifier: MIT
#include "delaunay/kernels/lane_kernels_body.hpp"

namespace geomesh::detail {
const LaneKernels avx2_kernels{walk, grow};
}  // namespace geomesh::detail
