// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Conversion between any two systems of the EPSG register, by PROJ, which a module holds: what GeographicLib does not
/// serve, and all that changes the datum.
#pragma once

#include <memory>
#include <string>

#include "coordinates/crs.hpp"

namespace geomesh::geomodel {

/// Whether the register knows the system as one of longitude and latitude. False where it does not, or is not there.
bool is_geographic(const HorizontalCrs& crs);

class ProjConversion {
 public:
  /// Throws Error{usage} with PROJ's reason where it does not know a system, or knows no way between their datums.
  ProjConversion(const HorizontalCrs& from, const HorizontalCrs& to);
  ~ProjConversion();
  ProjConversion(ProjConversion&&) noexcept;

  /// Metres, or degrees of longitude and latitude, both ways; x east and y north whatever the register says. Throws
  /// Error{invalid_input} where PROJ cannot convert the point.
  Vec2 convert(const Vec2& p) const;
  /// "; datum shift from A to B by PROJ", empty where the datum is the same.
  const std::string& datum_shift() const { return datum_shift_; }

 private:
  struct Operation;
  std::unique_ptr<Operation> operation_;
  double from_metres_ = 1, to_metres_ = 1;  ///< per unit of the systems; 1 for degrees
  std::string names_, datum_shift_;
};

}  // namespace geomesh::geomodel
