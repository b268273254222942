// SPDX-License-Identifier: MIT
/// @file
/// Insertion order: biased randomized insertion order (Amenta, Choi and Rote 2003) with a Hilbert curve inside each round.
#pragma once

#include <span>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh {

/// Permutation of `subset` (rows of points). Deterministic; depends on the coordinates only. O(n log n).
std::vector<VertexIndex> spatial_order(std::span<const Vec3> points, std::vector<VertexIndex> subset);

}  // namespace geomesh
