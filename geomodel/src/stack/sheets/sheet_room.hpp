// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Computes how far vertices of sheets may move vertically before a horizon is farther from its data than allowed.
#pragma once

#include <vector>

#include "stack/sheets/sheet_approximation.hpp"

namespace geomesh::geomodel {

/// Largest moves in m, for each vertex one per horizon. They are at least `share_for_centring` of the allowed distance,
/// which the approximation leaves everywhere.
struct SheetRoom {
  std::vector<double> up, down;
};

/// A place between vertices moves by a weighted mean of their moves, so if no vertex moves farther than the place may,
/// the place does not either. The data's points, the crossings of edges in the map, and the vertices are examined. Near
/// pinch-out lines `room_at_pinch_outs` is allowed as well. Cost: nearly linear in the data.
SheetRoom room_of_sheets(const MapSheets& sheets, const MapSamples& samples, const SheetOptions& options);

}  // namespace geomesh::geomodel
