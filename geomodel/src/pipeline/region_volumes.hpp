// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Volumes of regions before surfaces moved within a tolerance, and the check that they changed by no more than it
/// allows.
#pragma once

#include <string>
#include <vector>

#include "geomesh/core/tetrahedralize.hpp"
#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Returns the volume of each component, summed without cancellation.
std::vector<double> component_volumes(const ConstrainedTetrahedralization& mesh);

/// Sets volume_of_input of each region from the volumes of its components before surfaces moved; does nothing if there
/// are none. `core` has the tetrahedra of `mesh`, in the same order.
void set_volumes_of_input(ModelMesh& mesh, const ConstrainedTetrahedralization& core,
                          const std::vector<double>& volumes);

/// Throws Error{cannot_mesh} naming each region whose volume differs from volume_of_input, if that is set, by more than
/// the tolerance times the area of its faces towards other regions or the outside. Faces only on box sides are left
/// out, because they do not move (rounding: 1e-12 of the volume). To first order, surfaces within the tolerance cannot
/// change the volume by more. `tolerance` is in the mesh's unit.
void require_volumes_within(const ModelMesh& mesh, double tolerance);

/// Returns a text for the user on each unit whose volume changed by more than a hundredth while surfaces were remeshed
/// within the tolerance, in the order of their names.
std::vector<std::string> volume_changes(const ModelMesh& mesh, double tolerance);

/// Throws Error{cannot_mesh} if the regions do not fill the model volume up to rounding (1e-9 of it), because a side of
/// it has a crack or a fold. If the model ends inside the volume, at a topography or floor, they may fill less.
void require_volume_filled(const ModelMesh& mesh, double volume, bool ends_inside);

}  // namespace geomesh::geomodel
