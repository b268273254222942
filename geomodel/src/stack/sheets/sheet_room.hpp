// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Computes how far vertices may move vertically before a horizon is farther from its data than allowed.
#pragma once

#include <vector>

#include "stack/sheets/sheet_approximation.hpp"

namespace geomesh::geomodel {

/// Largest vertical moves in m, one per vertex and horizon. They are at least `share_for_centring` of the allowed
/// distance, because the approximation leaves that much everywhere.
struct SheetRoom {
  std::vector<double> up, down;
};

/// Computes the largest vertical moves of vertices. A place between vertices moves by a weighted mean of their moves,
/// so it remains within the allowed distance if none of them moves farther than that place may. The data's points, the
/// crossings of edges in the map, and the vertices are examined. Near pinch-out lines `room_at_pinch_outs` is allowed
/// as well. Cost: nearly linear in the data.
SheetRoom room_of_sheets(const MapSheets& sheets, const MapSamples& samples, const SheetOptions& options);

}  // namespace geomesh::geomodel
