// SPDX-License-Identifier: MIT
/// @file
/// One run of refinement with surfaces kept within given tolerances, the places where that failed, and the tolerances
/// of the next run.
#pragma once

#include "geomesh/core/run_context.hpp"
#include "remesh/operations/operations.hpp"

namespace geomesh::remesh {

/// One complete run. If a promised tolerance cannot be kept the run ends early, and must be repeated with smaller
/// tolerances.
struct Attempt {
  RefineResult result;
  std::vector<Breach> breaches;
  std::vector<TightZone> crossings;
  bool holds() const { return breaches.empty() && crossings.empty(); }
};

/// Refines and improves the mesh. Throws as refine_and_improve does, except for failures that the attempt lists.
Attempt attempt_holding(const Hold& hold, const PiecewiseLinearComplex& plc, ConstrainedTetrahedralization input,
                        const RefineOptions& options, const RunContext& context);

/// Adds points where surfaces are not proven to be within the tolerance in both directions. Returns the places that
/// remain so.
Deviations hold_to_tolerance(Toolbox& tools, const RunContext& context);

/// Reduces the tolerances for the next run: everywhere if the tolerance was not proven, or if reducing it locally twice
/// was not enough; locally where surfaces intersect.
void tighten(Hold& hold, const Attempt& attempt, double tolerance);

/// Facets to be kept unchanged while the rest of their surface is remeshed, because nothing else could be proven. Every
/// facet near a failed place of the attempt becomes a patch of its own, so its sides are curves and its corners are
/// kept. Segments there become curves of their own. Returns a place for each facet to which this is new.
/// `options` must have one patch for each facet.
std::vector<KeptPlace> keep_there(const PiecewiseLinearComplex& plc, const Attempt& attempt, RefineOptions& options);

/// Logs the places that are not within the tolerance; the first of them in detail (debug level).
void tell_what_is_off(const Attempt& attempt, const RunContext& context);

}  // namespace geomesh::remesh
