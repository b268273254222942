// SPDX-License-Identifier: MIT
#include "delaunay/lane_kernels_body.hpp"

namespace geomesh::detail {
const LaneKernels avx2_kernels{walk, grow};
}  // namespace geomesh::detail
