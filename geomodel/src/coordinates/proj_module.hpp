// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The interface between conversions of coordinates and the module that implements them with PROJ
/// (geomodel/plugins/proj.cpp). C++ types are passed through it, so both sides must come from the same build.
#pragma once

#include <memory>
#include <string>

#include "coordinates/crs.hpp"

namespace geomesh::geomodel {

class ProjOperation {
 public:
  virtual ~ProjOperation() = default;
  /// Transforms a point, in the units of the two systems, with x east and y north. The result is not finite if PROJ
  /// cannot convert the point.
  virtual Vec2 transform(const Vec2& p) const = 0;
  /// Returns PROJ's reason why the last point could not be converted to the other system.
  virtual std::string reason() const = 0;

  double from_metres = 1, to_metres = 1;  ///< metres per unit of the two coordinate systems; 1 for degrees
  std::string datum_shift;                ///< as ProjConversion::datum_shift()
};

struct ProjModule {
  const char* version;  ///< GEOMESH_MODULE_VERSION
  /// Returns whether a coordinate system of the EPSG register has longitude and latitude.
  bool (*is_geographic)(const HorizontalCrs& crs);
  /// Prepares a transformation between two systems. Throws Error{usage} with PROJ's reason if there is none.
  std::unique_ptr<ProjOperation> (*make)(const HorizontalCrs& from, const HorizontalCrs& to);
};

}  // namespace geomesh::geomodel
