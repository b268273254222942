// SPDX-License-Identifier: MIT
/// @file
/// How many elements refinement will make, and what asks for them, before the work.
#pragma once

#include <cstddef>

#include "geomesh/core/refine.hpp"

namespace geomesh {

/// Numbers of elements. Each part is what comes on top of the parts before it.
struct ElementEstimate {
  double by_volume = 0;      ///< SizeOptions::global alone, on the surfaces as they are
  double by_sizes = 0;       ///< sizes of units, surfaces, curves and places, a background, edges of the input
  double by_thin_units = 0;  ///< the first `n_thin` of SizeOptions::sources
  double by_bends = 0;       ///< surfaces within the tolerance, or within an angle of curvature
  double by_gaps = 0;        ///< gaps between surfaces, and layers across components
  double total() const { return by_volume + by_sizes + by_thin_units + by_bends + by_gaps; }
};

/// The total is that of estimate_elements (refine.hpp): within 30 % of what comes out. Preconditions and errors are
/// those of refine_and_improve. Takes seconds however many elements that are; near-linear in the cells of `mesh`.
ElementEstimate estimate_by_cause(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                                  const RefineOptions& options, std::size_t n_thin = 0);

}  // namespace geomesh
