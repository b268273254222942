// SPDX-License-Identifier: MIT
/// @file
/// Facets of a sampled complex that rounding has made meet.
#pragma once

#include <vector>

#include "geomesh/core/plc.hpp"

namespace geomesh::remesh {

/// Returns facets that cannot be triangulated, that share a triangle with another one, or that meet another facet or a
/// segment outside shared vertices and edges. Ascending. The engine reports one such place and ends there. O(n log n),
/// plus the pairs whose boxes overlap.
std::vector<Index> facets_that_meet(const PiecewiseLinearComplex& plc, unsigned threads);

}  // namespace geomesh::remesh
