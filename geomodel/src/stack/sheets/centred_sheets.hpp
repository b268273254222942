// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Sheets of a stack moved so that units keep their volumes.
#pragma once

#include "stack/sheets/sheet_approximation.hpp"

namespace geomesh::geomodel {

/// Moves vertices along the vertical until each horizon has the mean height that data and rules give it, about each
/// vertex. Triangles on a bend are all off to one side, and so is a closing unit that has a least thickness. The rules
/// are those of the stack at every place of the map: shared where `areas` say so, elsewhere at least `options.gap`
/// apart. What a vertex cannot take is left to its neighbours. No vertex moves further than `share_for_centring` of
/// what is allowed; by half of the least thickness more where a unit closes. The order of the horizons stays. Cost:
/// near-linear in the samples.
void centre_sheets(MapSheets& sheets, const MapSamples& samples, const std::vector<ThinArea>& areas,
                   const SheetOptions& options);

}  // namespace geomesh::geomodel
