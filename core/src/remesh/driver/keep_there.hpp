// SPDX-License-Identifier: MIT
/// @file
/// Facets that are kept as they are while the rest of their surfaces is remeshed: where nothing else could be proven to
/// be within the tolerance.
#pragma once

#include "geomesh/core/refine.hpp"
#include "remesh/driver/hold_surfaces.hpp"

namespace geomesh::remesh {

/// Every facet near a place of the attempt that does not hold becomes a patch of its own: its sides are curves then,
/// its corners stay. Segments there become curves of their own. Returns a place for each that was not so before.
/// `options` come with one patch for each facet.
std::vector<KeptPlace> keep_there(const PiecewiseLinearComplex& plc, const Attempt& attempt, RefineOptions& options);

}  // namespace geomesh::remesh
