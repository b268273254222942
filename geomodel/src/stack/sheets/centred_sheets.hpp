// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Moves ordered horizons vertically so that units keep their volumes.
#pragma once

#include "stack/sheets/sheet_approximation.hpp"

namespace geomesh::geomodel {

/// Moves vertices vertically until each horizon has, on average around each vertex, the height that data and rules give
/// it. Without this, triangles on a bend all lie on one side of the data, and so does a closing unit that has a least
/// thickness. The rules hold at every place of the map: horizons coincide where `areas` say so, elsewhere they are at
/// least `options.gap` apart. A correction that a vertex cannot take is passed to its neighbours. No vertex moves
/// farther than its room (SheetRoom), so that horizons stay within the allowed distance of their data. Where a unit
/// closes, the horizon that is moved has room for at least half of the least thickness. The order of the horizons is
/// preserved. Cost: nearly linear in the samples.
void centre_sheets(MapSheets& sheets, const MapSamples& samples, const std::vector<ThinArea>& areas,
                   const SheetOptions& options);

}  // namespace geomesh::geomodel
