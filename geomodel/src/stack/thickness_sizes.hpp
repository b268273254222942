// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Target sizes that thin units of a stack require.
#pragma once

#include <vector>

#include "geomesh/core/size_field.hpp"
#include "stack/sheets/sheet_approximation.hpp"

namespace geomesh::geomodel {

struct ThicknessSizeOptions {
  double size = 0;  ///< target size away from thin units, in m; larger sizes are not requested
  /// Least thickness of a unit in m that is considered; a thinner unit requests the size of this thickness.
  double thickness = 0;
  double of_thickness = 0;  ///< largest length of edges in a unit, as a multiple of its thickness
};

/// Returns places half-way between neighbouring horizons, on a raster of the map, each with the size that the unit's
/// thickness requires. The ratio of a thin unit's thickness to the edges across it limits the shape of elements.
std::vector<SizeSource> sizes_of_thickness(const MapSheets& sheets, const MapBounds& bounds,
                                           const ThicknessSizeOptions& options);

}  // namespace geomesh::geomodel
