// SPDX-License-Identifier: MIT
/// @file
/// One run of refinement with surfaces kept within tolerances, where that failed, and the tolerances of the next run.
#pragma once

#include "geomesh/core/run_context.hpp"
#include "remesh/operations/operations.hpp"

namespace geomesh::remesh {

/// The result of one run of refinement and improvement. If a surface cannot be kept within its tolerance, the run ends
/// early and must be repeated with smaller tolerances.
struct Attempt {
  RefineResult result;
  std::vector<Breach> breaches;
  std::vector<TightZone> crossings;
  bool holds() const { return breaches.empty() && crossings.empty(); }
};

/// Refines and improves the mesh. Throws as refine_and_improve does, but lists places where a tolerance was not kept.
Attempt attempt_holding(const Hold& hold, const PiecewiseLinearComplex& plc, ConstrainedTetrahedralization input,
                        const RefineOptions& options, const RunContext& context);

/// Adds points where surfaces are not proven to be within the tolerance in both directions. Returns the places where
/// this is still not proven.
Deviations hold_to_tolerance(Toolbox& tools, const RunContext& context);

/// Reduces the tolerances for the next run: locally where surfaces intersect, and everywhere if a surface was not
/// proven to be within its tolerance or if two local reductions were not enough.
void tighten(Hold& hold, const Attempt& attempt, double tolerance);

/// Chooses facets that are kept unchanged while the rest of their surface is remeshed, because no remeshed surface
/// could be proven to be within the tolerance there. Every facet near a failed place of the attempt becomes a patch of
/// its own, so its sides are curves and its corners are kept. Segments near such a place become curves of their own.
/// Returns a place for each facet that was not kept before. `options` must have one patch for each facet.
std::vector<KeptPlace> keep_there(const PiecewiseLinearComplex& plc, const Attempt& attempt, RefineOptions& options);

/// Logs the places that are not within the tolerance; the first of them in detail (debug level).
void tell_what_is_off(const Attempt& attempt, const RunContext& context);

}  // namespace geomesh::remesh
