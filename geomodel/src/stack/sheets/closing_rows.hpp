// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// How a unit of a settled stack ends: steeply, over one row of triangles along its pinch-out line.
#pragma once

#include "stack/sheets/sheet_approximation.hpp"

namespace geomesh::geomodel {

/// Cuts the triangles outside of each pinch-out line at `width` from it, or half-way where they are shorter. The unit
/// is there as thick as in the data about the cut, and at least the least thickness (`options.gap`). So it closes at an
/// angle that elements can have, where grids thin out at a fraction of a degree. One pass a pair of neighbours,
/// near-linear in the triangles.
void close_units(MapSheets& sheets, const MapSamples& samples, const SheetOptions& options, double width);

}  // namespace geomesh::geomodel
