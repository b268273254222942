// SPDX-License-Identifier: MIT
/// @file
/// Meshes a complex anew, to replace another mesh with the same components.
#pragma once

#include <optional>
#include <vector>

#include "geomesh/core/error.hpp"
#include "geomesh/core/plc.hpp"
#include "geomesh/core/run_context.hpp"
#include "geomesh/core/tetrahedralize.hpp"

namespace geomesh::remesh {

/// Returns the mesh of `plc` with the components of `mesh`, identified by the facets: `row_of_facet` gives for each
/// facet of `mesh` its row in `plc`. Components that `mesh` does not have are left out. Returns nothing if the complex
/// cannot be meshed (rounding may make facets cross, or leave no room for a double; `trouble` then contains the place),
/// or if components cannot be identified.
std::optional<ConstrainedTetrahedralization> tetrahedralize_as(const ConstrainedTetrahedralization& mesh,
                                                               const std::vector<Index>& row_of_facet,
                                                               PiecewiseLinearComplex plc, const RunContext& context,
                                                               ErrorContext* trouble = nullptr);

/// Replaces the mesh by the constrained Delaunay mesh of the same points, faces and edges. The numbers of facets,
/// segments, components and input vertices are preserved, the cells are new, and a few points may be added.
/// Precondition: every face on the border of the mesh is in `mesh.faces`. If this is impossible the mesh is not
/// changed, and false is returned.
bool mesh_anew(ConstrainedTetrahedralization& mesh, const RunContext& context);

}  // namespace geomesh::remesh
