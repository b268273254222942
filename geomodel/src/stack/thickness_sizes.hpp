// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Target sizes that thin units of a settled stack require.
#pragma once

#include <vector>

#include "geomesh/core/size_field.hpp"
#include "stack/sheets/sheet_approximation.hpp"

namespace geomesh::geomodel {

struct ThicknessSizeOptions {
  double size = 0;  ///< target size otherwise, in m; a larger one is not requested
  /// Least thickness of a unit in m; a thinner unit requests the size that belongs to this thickness.
  double thickness = 0;
  double of_thickness = 0;  ///< edges are at most this many times as long as a unit is thick
};

/// Returns places half-way between neighbours, on a raster of the map, with the size that the thickness there requires.
/// The shape of elements across a thin unit is limited by the ratio of its thickness to their edges.
std::vector<SizeSource> sizes_of_thickness(const MapSheets& sheets, const MapBounds& bounds,
                                           const ThicknessSizeOptions& options);

}  // namespace geomesh::geomodel
