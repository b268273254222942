// SPDX-License-Identifier: MIT
/// @file
/// Removes triangles without area from surfaces that may be remeshed.
#pragma once

#include <span>
#include <vector>

#include "geomesh/core/plc.hpp"

namespace geomesh::remesh {

/// Flips the longest edge of each of `slivers` if possible. This requires that the edge has two triangles of one
/// provenance with nothing inside, and no segment on it. The surface moves by less than the sliver's height. Returns
/// the remaining slivers in their order. O(n log n) for n facets.
std::vector<Index> flip_slivers(PiecewiseLinearComplex& plc, std::span<const Index> slivers);

}  // namespace geomesh::remesh
