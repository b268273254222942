// SPDX-License-Identifier: MIT
/// @file
/// Refinement to sizes that keeps the mesh strictly Delaunay, for finite volumes on its Voronoi dual.
#pragma once

#include "geomesh/core/refine.hpp"

namespace geomesh {

/// Meshes `plc` in conforming mode and adds points until cells and faces are as small as the size field asks:
/// circumcentres, and middles of segments, by insertion into the Delaunay triangulation. Cells that are more than twice
/// as wide (circumradius) as their shortest edge is long get a point too, where there is room. Flat cells with
/// well-spaced vertices (slivers) stay: nothing is flipped or moved, since that would leave Delaunay. Stage reported:
/// refine.
///
/// `mesh` is a result of tetrahedralize(plc) in conforming mode: the sizes, and which components to refine, are read
/// from it; its components keep their numbers. `options.size` and `max_elements` are honoured; quality and time budget
/// have no meaning here. The result says `delaunay` as the exact check of every face finds it, and lists the facets
/// that are not in recovery.facets_not_recovered.
///
/// Where small angles need more points than conforming recovery may add, the model is refined in constrained mode
/// instead, as tetrahedralize does: with a warning, delaunay = false, and the facets that are not Delaunay listed.
///
/// Throws Error{usage} for a tolerance of surfaces, Error{cannot_mesh} where the (estimated) number of elements exceeds
/// the limit. Ends always: no point is added nearer to others than 0.45 of the asked size but for those of conforming
/// recovery, which has budgets. Deterministic.
///
/// Sources: Shewchuk 1998, Tetrahedral mesh generation by Delaunay refinement (encroachment); Si 2009, section 3
/// (sizes); Ruppert 1995, section 5 (shells about small angles).
RefineResult refine_conforming(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                               const TetrahedralizeOptions& meshing, const RefineOptions& options,
                               const RunContext& context = {});

}  // namespace geomesh
