// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Where the walls of a fault zone are.
#pragma once

#include <vector>

#include "fault_zones/zone_columns.hpp"

namespace geomesh::geomodel {

/// Moves the nodes of each open column apart. `mesh`: split along the faults, both nodes of a column in one place.
///
/// The planes of the fault's faces at a node move by half of the thickness in the mean. So a node moves further where
/// they are inclined to each other. The shortest such move is taken that stays in the surfaces which meet the fault at
/// the node, on that side of it. Those are sides of the model always, and two others as long as the way is not more
/// than twice as long. Coordinates across a side along the axes do not change by a bit.
///
/// Throws Error{cannot_mesh} with fault and place where the fault bends by more than 120 degrees. So it does where the
/// fault lies nearly in a side of the model, and the move would be four times as long.
void move_walls(ModelMesh& mesh, const ZoneColumns& zone, const std::vector<FaultZone>& zones);

}  // namespace geomesh::geomodel
