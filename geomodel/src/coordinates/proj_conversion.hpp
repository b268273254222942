// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Conversion between any two systems of the EPSG register with PROJ, which is in a module: used for systems that
/// GeographicLib does not support, and for all changes of the datum.
#pragma once

#include <memory>
#include <string>

#include "coordinates/crs.hpp"

namespace geomesh::geomodel {

/// Returns whether the register has the system as one of longitude and latitude. False if it does not contain it, or is
/// not available.
bool is_geographic(const HorizontalCrs& crs);

class ProjConversion {
 public:
  /// Throws Error{usage} with PROJ's reason if it does not know a system, or has no transformation between their
  /// datums.
  ProjConversion(const HorizontalCrs& from, const HorizontalCrs& to);
  ~ProjConversion();
  ProjConversion(ProjConversion&&) noexcept;

  /// Converts metres, or degrees of longitude and latitude, in both directions; x is east and y north whatever the
  /// register says. Throws Error{invalid_input} if PROJ cannot convert the point.
  Vec2 convert(const Vec2& p) const;
  /// Returns "; datum shift from A to B by PROJ", empty if the datum is the same.
  const std::string& datum_shift() const { return datum_shift_; }

 private:
  struct Operation;
  std::unique_ptr<Operation> operation_;
  double from_metres_ = 1, to_metres_ = 1;  ///< metres per unit of the systems; 1 for degrees
  std::string names_, datum_shift_;
};

}  // namespace geomesh::geomodel
