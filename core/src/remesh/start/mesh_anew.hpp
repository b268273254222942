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

/// The mesh of `plc` with the components of `mesh`, told by the facets: `row_of_facet` gives for each facet of `mesh`
/// its row in `plc`. Nothing of a component that `mesh` lacks. Nothing at all where the complex cannot be meshed (as
/// where rounding made facets cross, or leaves no room for a double: `trouble` then tells where), or components cannot
/// be told.
std::optional<ConstrainedTetrahedralization> tetrahedralize_as(const ConstrainedTetrahedralization& mesh,
                                                               const std::vector<Index>& row_of_facet,
                                                               PiecewiseLinearComplex plc, const RunContext& context,
                                                               ErrorContext* trouble = nullptr);

/// Exchanges the mesh for the constrained Delaunay start of the same points, faces and edges: rows of facets, segments,
/// components and input vertices as they were, cells new, points perhaps a few more. Precondition: every face of the
/// mesh's border is in `mesh.faces`. Where that cannot be the mesh stays as it is, and false is returned.
bool mesh_anew(ConstrainedTetrahedralization& mesh, const RunContext& context);

}  // namespace geomesh::remesh
