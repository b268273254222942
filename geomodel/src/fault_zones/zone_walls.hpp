// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Moves the walls of fault zones apart.
#pragma once

#include <vector>

#include "fault_zones/zone_columns.hpp"

namespace geomesh::geomodel {

/// Moves the two end nodes of each open column (the copies of a node on the two sides of a fault) apart. Precondition:
/// `mesh` is split along the faults, with both nodes of a column in one place.
///
/// The planes of the fault's faces at a node move by half of the thickness on average, so the node itself moves farther
/// where these planes are inclined to each other. The node takes the shortest such movement that remains in the
/// surfaces which meet the fault on this side: always in sides of the model, and in up to two other surfaces as long as
/// this makes the movement at most twice as long. On a side along the axes, the fixed coordinate remains exactly the
/// same.
///
/// Throws Error{cannot_mesh} with fault and place if the fault bends by more than 120 degrees, or if it lies nearly in
/// a side of the model and the movement would be four times as long.
void move_walls(ModelMesh& mesh, const ZoneColumns& zone, const std::vector<FaultZone>& zones);

}  // namespace geomesh::geomodel
