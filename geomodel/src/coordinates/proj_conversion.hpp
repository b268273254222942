// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Conversion between any two coordinate systems of the EPSG register by PROJ, which is in a module. It is used for
/// systems that GeographicLib does not support, and for all changes of the datum.
#pragma once

#include <memory>
#include <string>

#include "coordinates/crs.hpp"

namespace geomesh::geomodel {

/// Returns whether a coordinate system has longitude and latitude according to the EPSG register. False if the register
/// does not contain the system, or is not available.
bool is_geographic(const HorizontalCrs& crs);

class ProjConversion {
 public:
  /// Prepares the conversion between two coordinate systems. Throws Error{usage} with PROJ's reason if PROJ does not
  /// know a system, or has no transformation between their datums.
  ProjConversion(const HorizontalCrs& from, const HorizontalCrs& to);
  ~ProjConversion();
  ProjConversion(ProjConversion&&) noexcept;

  /// Converts a point from the first system to the second. Coordinates are in metres or degrees, with x east and y
  /// north whatever the register says. Throws Error{invalid_input} if PROJ cannot convert the point.
  Vec2 convert(const Vec2& p) const;
  /// Returns the text "; datum shift from A to B by PROJ", or an empty text if both systems have the same datum.
  const std::string& datum_shift() const { return datum_shift_; }

 private:
  struct Operation;
  std::unique_ptr<Operation> operation_;
  double from_metres_ = 1, to_metres_ = 1;  ///< metres per unit of the two coordinate systems; 1 for degrees
  std::string names_, datum_shift_;
};

}  // namespace geomesh::geomodel
