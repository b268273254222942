// SPDX-License-Identifier: MIT
/// @file
/// The passes that bring the mesh to the size field: curves, then surfaces, then the inside.
#pragma once

#include "geomesh/core/run_context.hpp"
#include "remesh/operations/operations.hpp"

namespace geomesh::remesh {

/// All passes below, in their order.
void refine_to_size(Toolbox& tools, const RefineOptions& options, const RunContext& context);

/// Collapses edges shorter than 0.6 of their size: those on curves and surfaces (where they may) or, with
/// `inside_only`, others.
std::size_t collapse_short_edges(Toolbox& tools, bool inside_only, const RunContext& context);

/// Collapses edges at inner vertices that are shorter than half of their size where the worst shape does not fall below
/// the lesser of what it was and `floor`: points that turn out not to be needed. O(n log n).
std::size_t thin_out_inside(Toolbox& tools, double floor, const RunContext& context);
/// The same of edges between vertices on surfaces that are shorter than two fifths of their size, within the tolerance.
std::size_t thin_out_surfaces(Toolbox& tools, double floor, const RunContext& context);

/// Splits edges of curves (or else of surfaces) longer than 1.4 times their size, longest first. Throws
/// Error{cannot_mesh} beyond max_cells, as the other passes that add points do.
std::size_t split_long_edges(Toolbox& tools, bool curves, std::size_t max_cells, const RunContext& context);

/// Inserts points on faces larger than asked, front by front from curves and small faces.
std::size_t refine_surfaces(Toolbox& tools, std::size_t max_cells, const RunContext& context);

/// Makes faces of good shape within patches by exchanging edges and moving points, cells allowing.
void regularize_surfaces(Toolbox& tools, const RunContext& context);

/// Inserts points into cells larger than asked until there are none that admit one.
std::size_t refine_inside(Toolbox& tools, std::size_t max_cells, const RunContext& context);

}  // namespace geomesh::remesh
