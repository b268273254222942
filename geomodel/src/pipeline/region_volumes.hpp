// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Records the volumes of regions before surfaces were moved within a tolerance, and checks that they changed by no
/// more than the tolerance allows.
#pragma once

#include <string>
#include <vector>

#include "geomesh/core/tetrahedralize.hpp"
#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Returns the volume of each component of the mesh, summed without cancellation.
std::vector<double> component_volumes(const ConstrainedTetrahedralization& mesh);

/// Sets `volume_of_input` of each region from the volumes of its components before surfaces were moved; does nothing if
/// no volumes are given. `core` has the tetrahedra of `mesh`, in the same order.
void set_volumes_of_input(ModelMesh& mesh, const ConstrainedTetrahedralization& core,
                          const std::vector<double>& volumes);

/// Throws Error{cannot_mesh} naming each region whose volume differs from volume_of_input, if that is set, by more than
/// the tolerance times the area of its faces towards other regions or the outside. Faces only on box sides are left
/// out, because they do not move (rounding: 1e-12 of the volume). To first order, moving surfaces within the tolerance
/// cannot change the volume by more than that. `tolerance` is in the mesh's unit.
void require_volumes_within(const ModelMesh& mesh, double tolerance);

/// Describes each unit whose volume changed by more than a hundredth while surfaces were remeshed within the tolerance,
/// as messages for the user in the order of the units' names.
std::vector<std::string> volume_changes(const ModelMesh& mesh, double tolerance);

/// Throws Error{cannot_mesh} if the regions do not fill the model volume up to 1e-9, because a side has a crack or a
/// fold. If the model ends inside the volume, at a topography or floor, the regions may fill less.
void require_volume_filled(const ModelMesh& mesh, double volume, bool ends_inside);

}  // namespace geomesh::geomodel
