// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Shapes how a unit ends at its pinch-out line: steeply, over one row of triangles.
#pragma once

#include "stack/sheets/sheet_approximation.hpp"

namespace geomesh::geomodel {

/// Cuts the triangles outside each pinch-out line at the distance `width` from it, or half-way if they are shorter. At
/// the cut, the unit is as thick as the data around it, and at least as the least thickness (`options.gap`). It
/// therefore closes at an angle that elements can have, whereas gridded units thin out at a fraction of a degree. One
/// pass for each pair of neighbouring horizons, nearly linear in the triangles.
void close_units(MapSheets& sheets, const MapSamples& samples, const SheetOptions& options, double width);

}  // namespace geomesh::geomodel
