// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Extends faults that end inside the model so that they separate blocks.
#pragma once

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Extends a fault that ends inside the box to beyond `reach`, and returns the index of the first added triangle.
/// `reach` is a larger box that contains the horizons to be divided. For a fault that does not end inside the box,
/// returns its number of triangles. The extension separates blocks and is removed from the model afterwards.
Index continue_fault(TriangulatedSurface& fault, const Box3& box, const Box3& reach);

}  // namespace geomesh::geomodel
