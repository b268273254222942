// SPDX-License-Identifier: MIT
/// @file
/// One run of refinement with surfaces kept within given tolerances, the places where that failed, and the tolerances
/// of the next run.
#pragma once

#include "geomesh/core/run_context.hpp"
#include "remesh/operations/operations.hpp"

namespace geomesh::remesh {

/// A whole run. A broken promise ends it early: it has to be repeated with smaller tolerances.
struct Attempt {
  RefineResult result;
  std::vector<Breach> breaches;
  std::vector<TightZone> crossings;
  bool holds() const { return breaches.empty() && crossings.empty(); }
};

/// Refines and improves. Throws as refine_and_improve does, except for faults that the attempt lists.
Attempt attempt_holding(const Hold& hold, const PiecewiseLinearComplex& plc, ConstrainedTetrahedralization input,
                        const RefineOptions& options, const RunContext& context);

/// Adds points where surfaces are not proven to be within the tolerance both ways. Returns the places that remain in
/// the end.
Deviations hold_to_tolerance(Toolbox& tools, const RunContext& context);

/// Reduces the tolerances for the next run: everywhere if the tolerance was not proven, or if reducing it at places
/// twice was not enough; and where surfaces came to cross.
void tighten(Hold& hold, const Attempt& attempt, double tolerance);

/// Facets that are kept as they are while the rest of their surfaces is remeshed, because nothing else could be proven.
/// Every facet near a failed place of the attempt becomes a patch of its own, so that its sides are curves and its
/// corners are kept. Segments there become curves of their own. Returns a place for each that was not so before.
/// `options` have one patch for each facet.
std::vector<KeptPlace> keep_there(const PiecewiseLinearComplex& plc, const Attempt& attempt, RefineOptions& options);

/// Logs the places that are not within the tolerance, the first ones in detail (debug).
void tell_what_is_off(const Attempt& attempt, const RunContext& context);

}  // namespace geomesh::remesh
