// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// How far vertices of sheets may move along the vertical before a horizon is further from its data than allowed.
#pragma once

#include <vector>

#include "stack/sheets/sheet_approximation.hpp"

namespace geomesh::geomodel {

/// Per vertex one a horizon, m. Never less than `share_for_centring` of what is allowed, which the approximation leaves
/// everywhere.
struct SheetRoom {
  std::vector<double> up, down;
};

/// A place between vertices moves by a mean of their moves: where none of them moves further than the place may, the
/// place does not. Looked at are the data's points, the crossings of edges in the map, and the vertices. About
/// pinch-out lines `room_at_pinch_outs` is allowed too. Cost: near-linear in the data.
SheetRoom room_of_sheets(const MapSheets& sheets, const MapSamples& samples, const SheetOptions& options);

}  // namespace geomesh::geomodel
