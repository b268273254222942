// SPDX-License-Identifier: MIT
/// @file
/// Sizes asked, what they come to before the work, and what was reached.
#pragma once

#include "geomesh/core/run_context.hpp"
#include "remesh/operations/operations.hpp"
#include "remesh/sizes/size_basis.hpp"

namespace geomesh::remesh {

/// Nothing where surfaces are kept. Else `options.tolerance` everywhere, or less: `options.tolerance_share` of the
/// size that the user asks for at the place, and half of the gap to the surface that faces it. That size is of the
/// whole model, units, surfaces, curves, places and background. `mesh` is the one that was given, before refinement.
LocalTolerance allowed_tolerance(const PiecewiseLinearComplex& plc, const DomainMesh& mesh,
                                 const RefineOptions& options);

/// Sizes asked: from the options, the input's edges, curvature (and a tolerance that limits it; 0: none) and gaps, on
/// the mesh as it was given; and the same without gaps.
struct SizeFields {
  SizeField all, without_gaps;
};
SizeFields build_size_field(const SizeBasis& basis, const DomainMesh& mesh, const RefineOptions& options,
                            const LocalTolerance& tolerance);
/// Builds the size field where it is needed once: the basis is made here and not kept.
SizeFields build_size_field(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options,
                            const LocalTolerance& tolerance);
/// The same with the tolerance that the options ask for.
SizeFields build_size_field(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options);

/// Sizes by name alone, without those that bends and gaps impose.
SizeField sizes_asked_by_name(const SizeBasis& basis, const DomainMesh& mesh, RefineOptions options);

/// For a mesh that is sparse inside (RefineOptions::sparse_growth): on surfaces and curves as they are now what is
/// asked there, and from there growing up to the ratio times what is asked.
SizeField sparse_sizes(const DomainMesh& mesh, const SizeField& asked, const RefineOptions& options);

/// Whether surfaces get points for sizes: where they may be remeshed they always do.
inline bool sizes_surfaces(const RefineOptions& o) { return o.size_surfaces || o.honour == Honour::tolerance; }
/// The greatest; 0 where surfaces are kept.
inline double size_tolerance(const RefineOptions& o) { return o.honour == Honour::tolerance ? o.tolerance : 0; }

/// What the sizes come to, told before the work. Throws Error{cannot_mesh} beyond the limit.
void announce_estimate(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options,
                       const RunContext& context, RefineResult& result);

/// Share of the edges that are between half and twice as long as asked.
double share_of_edges_within_size(Toolbox& tools, unsigned threads = 1);

/// How many elements the sizes come to: integrals over volume and faces of the inverse of what an element of the asked
/// size takes of them. Where surfaces keep their place, the cells that the mesh has before are counted too. Measured
/// within 30 % there. Takes seconds however many elements that are (size_integrals.hpp).
/// Counting ends where the number is above `enough`.
double estimate_elements(const DomainMesh& mesh, const SizeField& size, const RefineOptions& options,
                         double enough = std::numeric_limits<double>::infinity());

}  // namespace geomesh::remesh
