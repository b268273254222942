// SPDX-License-Identifier: MIT
/// @file
/// Meshes of a complex that take the place of another mesh of the same components.
#pragma once

#include <optional>
#include <vector>

#include "geomesh/core/error.hpp"
#include "geomesh/core/plc.hpp"
#include "geomesh/core/run_context.hpp"
#include "geomesh/core/tetrahedralize.hpp"

namespace geomesh::remesh {

/// Returns the mesh of `plc` with the components of `mesh`, identified by the facets: `row_of_facet` gives for each
/// facet of `mesh` its row in `plc`. Components that `mesh` lacks are left out. Returns nothing if the complex cannot
/// be meshed (rounding may make facets cross, or leave no room for a double; `trouble` then has the place), or if
/// components cannot be identified.
std::optional<ConstrainedTetrahedralization> tetrahedralize_as(const ConstrainedTetrahedralization& mesh,
                                                               const std::vector<Index>& row_of_facet,
                                                               PiecewiseLinearComplex plc, const RunContext& context,
                                                               ErrorContext* trouble = nullptr);

/// Exchanges the mesh for the constrained Delaunay start of the same points, faces and edges. Rows of facets, segments,
/// components and input vertices are as before, cells are new, and there may be a few more points. Precondition: every
/// face of the mesh's border is in `mesh.faces`. If that is impossible the mesh is unchanged, and false is returned.
bool mesh_anew(ConstrainedTetrahedralization& mesh, const RunContext& context);

}  // namespace geomesh::remesh
