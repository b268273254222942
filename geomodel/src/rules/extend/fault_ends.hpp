// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Faults that end inside the model, continued so that they part blocks.
#pragma once

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Continues a fault that ends inside the box to beyond `reach`, and gives the row of the first triangle made. `reach`
/// is a larger box, which holds the horizons to be parted. Leaves a fault that does not end there as it is and gives
/// its number of triangles. The continuation parts blocks from each other and is removed from the model afterwards.
Index continue_fault(TriangulatedSurface& fault, const Box3& box, const Box3& reach);

}  // namespace geomesh::geomodel
