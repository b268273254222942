// SPDX-License-Identifier: MIT
/// @file
/// The passes that bring the mesh to the size field: curves, then surfaces, then the inside.
#pragma once

#include "geomesh/core/run_context.hpp"
#include "refine/operations.hpp"

namespace geomesh::remesh {

/// Sizes asked: from the options, the input's edges, curvature (and a tolerance that limits it; 0: none) and gaps, on the mesh as
/// it was given; and the same without gaps.
struct SizeFields {
  SizeField all, without_gaps;
};
SizeFields build_size_field(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options, double tolerance);

/// Whether surfaces get points for sizes: where they may be remeshed they always do.
inline bool sizes_surfaces(const RefineOptions& o) { return o.size_surfaces || o.honour == Honour::tolerance; }
/// What build_size_field takes.
inline double size_tolerance(const RefineOptions& o) { return o.honour == Honour::tolerance ? o.tolerance : 0; }

/// Gives each face the facet of its patch that is nearest to it, oriented as it is.
void renew_facets(DomainMesh& mesh, const SurfaceGuard& guard, const PiecewiseLinearComplex& plc);

/// Puts a vertex of the nearest face (or curve edge), new or moved, to the place of each breach, where cells stay positive and of some shape
/// and fewer faces (none) are off the input than were (where none was). Returns how many were treated: other places may be off then, so verify again.
/// O(n log n).
std::size_t mend_surfaces(Toolbox& tools, const std::vector<Breach>& breaches);

/// What the sizes come to, told before the work. Throws Error{cannot_mesh} beyond the limit.
void announce_estimate(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options, const RunContext& context,
                       RefineResult& result);

/// Share of the edges that are between half and twice as long as asked.
double share_of_edges_within_size(Toolbox& tools);

/// How many elements the sizes come to: integrals over volume and faces of the inverse of what an element of the asked size takes of them, and the
/// cells that the mesh has before where surfaces keep their place. Measured within 30 % there. Not counted much farther than the limit of the options.
/// Near-linear in the result.
double estimate_elements(const DomainMesh& mesh, const SizeField& size, const RefineOptions& options);

/// All passes below, in their order.
void refine_to_size(Toolbox& tools, const RefineOptions& options, const RunContext& context);

/// Collapses edges shorter than 0.6 of their size: those on curves and surfaces (where they may) or, with `inside_only`, others.
std::size_t collapse_short_edges(Toolbox& tools, bool inside_only, const RunContext& context);

/// Collapses edges at inner vertices that are shorter than half of their size where the worst shape does not fall below the lesser of what it was and
/// `floor`: points that turn out not to be needed. O(n log n).
std::size_t thin_out_inside(Toolbox& tools, double floor, const RunContext& context);

/// Splits edges of curves (or else of surfaces) longer than 1.4 times their size, longest first. Throws Error{cannot_mesh} beyond
/// max_cells, as the other passes that add points do.
std::size_t split_long_edges(Toolbox& tools, bool curves, std::size_t max_cells, const RunContext& context);

/// Inserts points on faces larger than asked, front by front from curves and small faces.
std::size_t refine_surfaces(Toolbox& tools, std::size_t max_cells, const RunContext& context);

/// Flips (2-3 and 3-2) until no face admits one that makes it locally Delaunay: insertion works best from there.
std::size_t flip_towards_delaunay(Toolbox& tools, const RunContext& context);

/// Makes faces of good shape within patches by exchanging edges and moving points, cells allowing.
void regularize_surfaces(Toolbox& tools, const RunContext& context);

/// Inserts points into cells larger than asked until there are none that admit one.
std::size_t refine_inside(Toolbox& tools, std::size_t max_cells, const RunContext& context);

}  // namespace geomesh::remesh
