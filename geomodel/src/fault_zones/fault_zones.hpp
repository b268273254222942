// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Replaces faults by zones of volume elements between their two sides.
#pragma once

#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"
#include "geomesh/geomodel/write_options.hpp"

namespace geomesh::geomodel {

inline std::string zone_name(const std::string& fault) { return fault + ".zone"; }

/// Returns the mesh with these faults opened to zones. Nodes of a fault are doubled as split_along() does. The copies
/// move by half of the thickness to either side, along the surfaces on which they lie (zone_walls.hpp). Between them,
/// each face of the fault becomes a prism with `layers` layers, and each layer is divided into three tetrahedra. These
/// form the region FAULT.zone, which follows the other regions. The fault's faces become FAULT.minus and FAULT.plus,
/// with normals into the zone. If a node was not doubled (at a tip, and where the fault ends on another surface), the
/// zone ends as a wedge. Surfaces that cross the fault end at its walls. Where a zone reaches a side of the model, its
/// faces are added to that side.
///
/// ModelMesh::before_zones has the places of the nodes before. Patches and the curves at walls get new numbers and
/// names. Cell arrays have NaN in zones. Volumes, areas and counts are those of the opened mesh.
///
/// Throws Error{usage} if a fault has no face inside the mesh or is named more than once. Throws Error{cannot_mesh},
/// with names and place, if three sides of zones meet in a node, if a wall cannot follow the surfaces around it, or if
/// an element would not be positive. O(n log n). Precondition: the mesh is valid (validate_model_mesh()), of first
/// order and without prisms. The result is valid too.
ModelMesh open_fault_zones(const ModelMesh& mesh, const std::vector<FaultZone>& zones);

}  // namespace geomesh::geomodel
