// SPDX-License-Identifier: MIT
/// @file
/// Finds facets of a sampled complex that intersect because of rounding.
#pragma once

#include <vector>

#include "geomesh/core/plc.hpp"

namespace geomesh::remesh {

/// Returns, in ascending order, the facets that cannot be triangulated, that share a triangle with another one, or that
/// meet another facet or a segment other than at common vertices and edges. This search is needed because meshing
/// itself would report only the first of these places. O(n log n), plus the pairs whose boxes overlap.
std::vector<Index> facets_that_meet(const PiecewiseLinearComplex& plc, unsigned threads);

}  // namespace geomesh::remesh
