// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The border between conversions of coordinates and the module that makes them by PROJ (geomodel/plugins/proj.cpp).
/// Types of C++ cross it, so both sides are of one build.
#pragma once

#include <memory>
#include <string>

#include "coordinates/crs.hpp"

namespace geomesh::geomodel {

/// A way from one system to another.
class ProjOperation {
 public:
  virtual ~ProjOperation() = default;
  /// In the systems' own units, x east and y north. Not finite where PROJ cannot convert the point.
  virtual Vec2 transform(const Vec2& p) const = 0;
  /// Why the last point could not be converted.
  virtual std::string reason() const = 0;

  double from_metres = 1, to_metres = 1;  ///< per unit of the systems; 1 for degrees
  std::string datum_shift;                ///< as ProjConversion::datum_shift()
};

struct ProjModule {
  const char* version;  ///< GEOMESH_MODULE_VERSION
  /// Of a system of the register.
  bool (*is_geographic)(const HorizontalCrs& crs);
  /// Throws as the constructor of ProjConversion.
  std::unique_ptr<ProjOperation> (*make)(const HorizontalCrs& from, const HorizontalCrs& to);
};

}  // namespace geomesh::geomodel
