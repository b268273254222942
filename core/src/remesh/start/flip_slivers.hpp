// SPDX-License-Identifier: MIT
/// @file
/// Triangles of no width taken out of surfaces that may be remeshed.
#pragma once

#include <span>
#include <vector>

#include "geomesh/core/plc.hpp"

namespace geomesh::remesh {

/// Flips the longest edge of each of `slivers` where it may go: two triangles of one provenance are at it, nothing
/// inside them, and no segment on it. The surface moves by less than the sliver's height. Returns the slivers that are
/// left, in their order. O(n log n) for n facets.
std::vector<Index> flip_slivers(PiecewiseLinearComplex& plc, std::span<const Index> slivers);

}  // namespace geomesh::remesh
