// SPDX-License-Identifier: MIT
/// @file
/// Meshing in conforming mode with a function of the caller's that recovers segments and facets.
#pragma once

#include <functional>
#include <vector>

#include "geomesh/core/tetrahedralize.hpp"
#include "recover/model/recover.hpp"

namespace geomesh {

/// A function that makes segments and facets unions of Delaunay edges and faces, and stores the facets that it gave up,
/// sorted. It returns false if more points than the budget allows were needed in all.
using ConformingStep = std::function<bool(recover::Recovery&, const RecoverOptions&, std::vector<Index>& given_up)>;

/// Meshes like tetrahedralize() in conforming mode, but recovers segments and facets by `step`. Throws
/// Error{cannot_mesh} in cases in which tetrahedralize() changes to constrained mode.
ConstrainedTetrahedralization tetrahedralize_conforming(const PiecewiseLinearComplex& plc,
                                                        const TetrahedralizeOptions& options, const RunContext& context,
                                                        const ConformingStep& step);

/// Adds to recovery.facets_not_recovered, sorted, each facet with a face that is not locally Delaunay: the vertex
/// opposite the face in one of its cells is in the circumsphere of the other cell. Exact.
void list_facets_off_delaunay(ConstrainedTetrahedralization& mesh);

}  // namespace geomesh
