// SPDX-License-Identifier: MIT
/// @file
/// The requested sizes, the number of elements that they require, and the sizes reached in the mesh.
#pragma once

#include "geomesh/core/run_context.hpp"
#include "remesh/operations/operations.hpp"
#include "remesh/sizes/size_basis.hpp"

namespace geomesh::remesh {

/// Returns the tolerance by place, or a tolerance of 0 if surfaces are kept exactly. It is `options.tolerance`
/// everywhere, or less: it is limited to `options.tolerance_share` times the requested size at the place, and to half
/// of the gap to the opposite surface. The requested size includes that of the whole model, of units, surfaces, curves,
/// places and the background. `mesh` is the input mesh before refinement.
LocalTolerance allowed_tolerance(const PiecewiseLinearComplex& plc, const DomainMesh& mesh,
                                 const RefineOptions& options);

/// Target sizes from the options, input edges, curvature (limited by a tolerance; 0: no limit) and gaps, on the input
/// mesh; once with and once without those of gaps.
struct SizeFields {
  SizeField all, without_gaps;
};
SizeFields build_size_field(const SizeBasis& basis, const DomainMesh& mesh, const RefineOptions& options,
                            const LocalTolerance& tolerance);
/// Builds the size fields from input edges and bends of surfaces (a SizeBasis) that are collected for this call only.
SizeFields build_size_field(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options,
                            const LocalTolerance& tolerance);
/// Builds the size fields with the tolerance that the options give.
SizeFields build_size_field(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options);

/// Returns the target sizes that are requested for the model, units, surfaces, curves and places, or follow from input
/// edges, without those from bends and gaps.
SizeField sizes_asked_by_name(const SizeBasis& basis, const DomainMesh& mesh, RefineOptions options);

/// Returns sizes for a mesh that is sparse inside (RefineOptions::sparse_growth): the requested sizes on surfaces and
/// curves, growing from there to a multiple of the requested size.
SizeField sparse_sizes(const DomainMesh& mesh, const SizeField& asked, const RefineOptions& options);

/// Returns whether surfaces get points to reach the target sizes. This is always true if surfaces may be remeshed.
inline bool sizes_surfaces(const RefineOptions& o) { return o.size_surfaces || o.honour == Honour::tolerance; }
/// Returns the largest tolerance, or 0 if surfaces are kept exactly.
inline double size_tolerance(const RefineOptions& o) { return o.honour == Honour::tolerance ? o.tolerance : 0; }

/// Reports the estimated number of elements before meshing. Throws Error{cannot_mesh} if it exceeds the limit.
void announce_estimate(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options,
                       const RunContext& context, RefineResult& result);

/// Estimates how many elements the sizes require, from integrals over volume and faces. If surfaces are kept, the cells
/// that the mesh already has are counted too. Measured errors are within 30 %. The estimate takes seconds for any
/// number of elements (size_integrals.hpp), and ends early once the number exceeds `enough`.
double estimate_elements(const DomainMesh& mesh, const SizeField& size, const RefineOptions& options,
                         double enough = std::numeric_limits<double>::infinity());

}  // namespace geomesh::remesh
