// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds the triangle of the ordered horizons' common triangulation over a place of the map, and the heights on it.
#pragma once

#include "rules/planar/map_locator.hpp"
#include "stack/sheets/sheet_approximation.hpp"

namespace geomesh::geomodel {

class SheetLocator {
 public:
  /// Precondition: `sheets` outlives the SheetLocator.
  explicit SheetLocator(const MapSheets& sheets);

  struct Place {
    Index triangle = no_index;  ///< index of the triangle that contains the place; no_index outside the triangulation
    std::array<double, 3> weights{};
  };
  Place find(const Vec2& p) const;
  /// Returns the height of a horizon at a place, or NaN if it is absent there.
  double height(const Place& at, std::size_t horizon) const;

 private:
  const MapSheets& sheets_;
  TriangulatedSurface surface_;
  MapLocator locator_;
};

}  // namespace geomesh::geomodel
