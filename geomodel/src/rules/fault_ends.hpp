// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Faults that end inside the model, continued so that they part blocks.
#pragma once

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Continues a fault that ends inside the box to beyond it and gives the row of the first triangle made; leaves one
/// that does not as it is and gives its number of triangles. The continuation parts blocks from each other and is
/// removed from the model afterwards.
Index continue_fault(TriangulatedSurface& fault, const Box3& box);

}  // namespace geomesh::geomodel
