// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Sheets of a stack moved so that units keep their volumes.
#pragma once

#include "stack/sheets/sheet_approximation.hpp"

namespace geomesh::geomodel {

/// Moves vertices along the vertical until each horizon has the mean height that data and rules give it, about each
/// vertex. Triangles on a bend are all off to one side, and so is a closing unit that has a least thickness. The rules
/// are those of the stack at every place of the map: shared where `areas` say so, elsewhere at least `options.gap`
/// apart. What a vertex cannot take is left to its neighbours. No vertex moves further than its room (`SheetRoom`), so
/// that horizons stay as near to their data as is allowed. Where a unit closes the one that gives way has at least half
/// of the least thickness. The order of the horizons stays. Cost: near-linear in the samples.
void centre_sheets(MapSheets& sheets, const MapSamples& samples, const std::vector<ThinArea>& areas,
                   const SheetOptions& options);

}  // namespace geomesh::geomodel
