// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Horizontal coordinate systems: their names, and conversion of those that GeographicLib supports.
#pragma once

#include <string>
#include <string_view>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

struct HorizontalCrs {
  enum class Kind {
    local,       ///< without a position on the globe
    geographic,  ///< x longitude, y latitude, in degrees
    utm,         ///< zone 0: to be determined
    polar,       ///< polar stereographic
    other,       ///< only its name is known
  };
  Kind kind = Kind::local;
  int zone = 0;
  bool north = true;
  int epsg = 0;         ///< 0: not given by code
  bool etrs89 = false;  ///< on ETRS89, else WGS84; the two are treated as equal (they differ by less than a metre)
  std::string text;     ///< as written

  bool converts() const { return kind == Kind::geographic || kind == Kind::utm || kind == Kind::polar; }
  /// Returns "utm 32N", "geographic", else the text as written.
  std::string name() const;
};

/// Parses "local", "geographic", "utm", "utm 32N" (also "UTM zone 32N", "utm32n"), "epsg:CODE"; case and blanks are
/// ignored. Anything else is of kind other.
HorizontalCrs parse_crs(std::string_view text);
/// Returns what is wrong with such a text in a project; empty if nothing is.
std::string complaint_about_crs(std::string_view text);

/// Returns whether two systems are the same, up to the datum.
bool same_system(const HorizontalCrs& a, const HorizontalCrs& b);

/// Returns longitude and latitude in degrees. Throws Error{invalid_input} if the point is outside the system's range.
/// Precondition: crs.converts(), zone known. Accurate to a micrometre (Karney, "Transverse Mercator with an accuracy of
/// a few nanometers", J. Geodesy 85, 2011).
Vec2 to_geographic(const HorizontalCrs& crs, const Vec2& p);
/// Returns metres, or degrees. Errors and precondition as above.
Vec2 from_geographic(const HorizontalCrs& crs, const Vec2& longitude_latitude);

/// Returns the UTM system of the zone in which a place lies (with the exceptions around Norway and Svalbard).
HorizontalCrs utm_at(const Vec2& longitude_latitude);

}  // namespace geomesh::geomodel
