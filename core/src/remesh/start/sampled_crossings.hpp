// SPDX-License-Identifier: MIT
/// @file
/// Facets of a sampled complex that rounding has made meet.
#pragma once

#include <vector>

#include "geomesh/core/plc.hpp"

namespace geomesh::remesh {

/// Facets that cannot be triangulated, that have a triangle of another one, or that meet something outside of shared
/// vertices and edges: another facet or a segment. Ascending. The engine tells one such place and ends there. O(n log
/// n) and the pairs whose boxes overlap.
std::vector<Index> facets_that_meet(const PiecewiseLinearComplex& plc, unsigned threads);

}  // namespace geomesh::remesh
