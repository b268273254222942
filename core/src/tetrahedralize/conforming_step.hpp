// SPDX-License-Identifier: MIT
/// @file
/// Meshing in conforming mode with an additional step beside the recovery of segments and facets.
#pragma once

#include <functional>
#include <vector>

#include "geomesh/core/tetrahedralize.hpp"
#include "recover/model/recover.hpp"

namespace geomesh {

/// Makes segments and facets unions of Delaunay edges and faces. Stores the facets that were given up, sorted. Returns
/// false if more points than the budget were needed in all.
using ConformingStep = std::function<bool(recover::Recovery&, const RecoverOptions&, std::vector<Index>& given_up)>;

/// Like tetrahedralize in conforming mode, with `step` instead of its own. Throws Error{cannot_mesh} where that would
/// change to constrained mode.
ConstrainedTetrahedralization tetrahedralize_conforming(const PiecewiseLinearComplex& plc,
                                                        const TetrahedralizeOptions& options, const RunContext& context,
                                                        const ConformingStep& step);

/// Adds to recovery.facets_not_recovered, sorted, each facet with a face between two cells of which one has the other's
/// vertex in its circumsphere. Exact.
void list_facets_off_delaunay(ConstrainedTetrahedralization& mesh);

}  // namespace geomesh
