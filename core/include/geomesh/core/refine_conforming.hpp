// SPDX-License-Identifier: MIT
/// @file
/// Refinement to target sizes that keeps the mesh strictly Delaunay, for finite volumes on its Voronoi dual.
#pragma once

#include "geomesh/core/refine.hpp"

namespace geomesh {

/// Meshes `plc` in conforming mode and adds points until cells and faces are no larger than the size field requests:
/// circumcentres, and midpoints of segments, by insertion into the Delaunay triangulation. Cells whose circumradius is
/// more than twice their shortest edge get a point too, if there is room. Flat cells with well-spaced vertices
/// (slivers) are kept: nothing is flipped or moved, because that would violate the Delaunay property. Stage reported:
/// refine.
///
/// `mesh` is a result of tetrahedralize(plc) in conforming mode: the sizes, and which components to refine, are read
/// from it; its components keep their numbers. `options.size` and `max_elements` are honoured; quality and time budget
/// are ignored. `delaunay` in the result comes from an exact check of every face; facets that are not Delaunay are
/// listed in recovery.facets_not_recovered. If small angles need more points than conforming recovery may add, the
/// model is refined in constrained mode instead, as tetrahedralize does: with a warning, delaunay = false, and the
/// facets that are not Delaunay listed. Throws Error{usage} for a tolerance of surfaces, Error{cannot_mesh} if the
/// (estimated) number of elements exceeds the limit. Always terminates: no point is added closer to another than 0.45
/// times the target size, except those of conforming recovery, which has budgets. Deterministic.
///
/// Sources: Shewchuk 1998, Tetrahedral mesh generation by Delaunay refinement (encroachment); Si 2009, section 3
/// (sizes); Ruppert 1995, section 5 (shells about small angles).
RefineResult refine_conforming(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                               const TetrahedralizeOptions& meshing, const RefineOptions& options,
                               const RunContext& context = {});

}  // namespace geomesh
