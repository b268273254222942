// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Sizes that thin units of a settled stack ask for.
#pragma once

#include <vector>

#include "geomesh/core/size_field.hpp"
#include "stack/sheets/sheet_approximation.hpp"

namespace geomesh::geomodel {

struct ThicknessSizeOptions {
  double size = 0;          ///< asked otherwise, m: more is not asked for
  double thickness = 0;     ///< least thickness of a unit, m: a unit asks for no less than this does
  double of_thickness = 0;  ///< edges are at most this many times as long as a unit is thick
};

/// Places half-way between neighbours, on a raster of the map, with the size that the thickness there asks for.
/// Elements across a thin unit cannot be less flat than the unit is thin against their edges.
std::vector<SizeSource> sizes_of_thickness(const MapSheets& sheets, const MapBounds& bounds,
                                           const ThicknessSizeOptions& options);

}  // namespace geomesh::geomodel
