// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Computes the places of the walls of a fault zone.
#pragma once

#include <vector>

#include "fault_zones/zone_columns.hpp"

namespace geomesh::geomodel {

/// Moves the nodes of each open column apart. `mesh` is split along the faults, with both nodes of a column in one
/// place.
///
/// The planes of the fault's faces at a node move by half of the thickness in the mean, so a node moves further where
/// they are inclined to each other. The shortest such movement is chosen that remains in the surfaces which meet the
/// fault at the node, on that side of it: always in sides of the model, and in up to two others as long as the movement
/// is not more than twice as long. Coordinates across a side along the axes do not change by a bit.
///
/// Throws Error{cannot_mesh} with fault and place if the fault bends by more than 120 degrees, or if it lies nearly in
/// a side of the model and the movement would be four times as long.
void move_walls(ModelMesh& mesh, const ZoneColumns& zone, const std::vector<FaultZone>& zones);

}  // namespace geomesh::geomodel
