// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Volumes of regions before surfaces moved within a tolerance, and that they changed by no more than that allows.
#pragma once

#include <string>
#include <vector>

#include "geomesh/core/tetrahedralize.hpp"
#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Volume of each component, summed without cancellation.
std::vector<double> component_volumes(const ConstrainedTetrahedralization& mesh);

/// Sets volume_of_input of each region from the volumes of its components before surfaces moved; none given: leaves it.
/// `core` has the tetrahedra of `mesh`, in the same order.
void set_volumes_of_input(ModelMesh& mesh, const ConstrainedTetrahedralization& core,
                          const std::vector<double>& volumes);

/// Throws Error{cannot_mesh} naming each region whose volume differs from volume_of_input, where that is told, by more
/// than area times tolerance: of its faces towards other regions or the outside, those of box sides alone left out, as
/// they do not move (rounding: 1e-12 of the volume). To first order surfaces within the tolerance cannot change it by
/// more. `tolerance` in the mesh's unit.
void require_volumes_within(const ModelMesh& mesh, double tolerance);

/// In words, for the user: units whose volume changed by more than a hundredth while surfaces were remeshed within the
/// tolerance. In the order of their names.
std::vector<std::string> volume_changes(const ModelMesh& mesh, double tolerance);

/// Throws Error{cannot_mesh} where the regions do not fill the model volume but for rounding (1e-9 of it): a side of it
/// has a crack or a fold then. Where the model ends inside of it, at a topography or floor, they may fill less.
void require_volume_filled(const ModelMesh& mesh, double volume, bool ends_inside);

}  // namespace geomesh::geomodel
