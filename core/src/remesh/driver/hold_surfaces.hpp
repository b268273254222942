// SPDX-License-Identifier: MIT
/// @file
/// One run of refinement with surfaces held so and so closely, what it did not keep, and how closely to hold them next.
#pragma once

#include "geomesh/core/run_context.hpp"
#include "remesh/operations/operations.hpp"

namespace geomesh::remesh {

/// A whole run. What is not as promised ends it early: it has to be done again, with surfaces held more closely.
struct Attempt {
  RefineResult result;
  std::vector<Breach> breaches;
  std::vector<TightZone> crossings;
  bool holds() const { return breaches.empty() && crossings.empty(); }
};

/// Refines and improves. Throws as refine_and_improve does, but for what the attempt lists.
Attempt attempt_holding(const Hold& hold, const PiecewiseLinearComplex& plc, ConstrainedTetrahedralization input,
                        const RefineOptions& options, const RunContext& context);

/// Where surfaces are not proven to be within the tolerance both ways, points are put there. Returns what is left in
/// the end.
Deviations hold_to_tolerance(Toolbox& tools, const RunContext& context);

/// More closely than in the attempt, for the next run: everywhere where the tolerance was not proven or it was not
/// enough to hold places twice, and where surfaces came to cross.
void tighten(Hold& hold, const Attempt& attempt, double tolerance);

/// Facets that are kept as they are while the rest of their surfaces is remeshed, where nothing else could be proven.
/// Every facet near a place of the attempt that does not hold becomes a patch of its own: its sides are curves then,
/// its corners stay. Segments there become curves of their own. Returns a place for each that was not so before.
/// `options` come with one patch for each facet.
std::vector<KeptPlace> keep_there(const PiecewiseLinearComplex& plc, const Attempt& attempt, RefineOptions& options);

/// Tells of what does not hold, and the first places (debug).
void tell_what_is_off(const Attempt& attempt, const RunContext& context);

}  // namespace geomesh::remesh
