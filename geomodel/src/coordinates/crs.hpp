// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Horizontal coordinate systems: their names, and conversion of those that GeographicLib serves.
#pragma once

#include <string>
#include <string_view>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

struct HorizontalCrs {
  enum class Kind {
    local,       ///< no place on the globe
    geographic,  ///< x longitude, y latitude, degrees
    utm,         ///< zone 0: to be found
    polar,       ///< polar stereographic
    other,       ///< known by its name alone
  };
  Kind kind = Kind::local;
  int zone = 0;
  bool north = true;
  int epsg = 0;         ///< 0: not given by code
  bool etrs89 = false;  ///< on ETRS89, else WGS84; the two are taken for one (they are less than a metre apart)
  std::string text;     ///< as written

  bool converts() const { return kind == Kind::geographic || kind == Kind::utm || kind == Kind::polar; }
  /// "utm 32N", "geographic", else as written.
  std::string name() const;
};

/// "local", "geographic", "utm", "utm 32N" (also "UTM zone 32N", "utm32n"), "epsg:CODE"; case and blanks do not matter.
/// Anything else is of kind other.
HorizontalCrs parse_crs(std::string_view text);
/// What is wrong with such a text in a project; empty where nothing is.
std::string complaint_about_crs(std::string_view text);

/// The same system, up to the datum.
bool same_system(const HorizontalCrs& a, const HorizontalCrs& b);

/// Longitude and latitude in degrees. Throws Error{invalid_input} where the point is beyond the system's range.
/// Precondition: crs.converts(), zone known. Accurate to a micrometre (Karney, "Transverse Mercator with an accuracy of
/// a few nanometers", J. Geodesy 85, 2011).
Vec2 to_geographic(const HorizontalCrs& crs, const Vec2& p);
/// Metres, or degrees. Errors and precondition as above.
Vec2 from_geographic(const HorizontalCrs& crs, const Vec2& longitude_latitude);

/// The UTM system of the zone that a place lies in (with the exceptions about Norway and Svalbard).
HorizontalCrs utm_at(const Vec2& longitude_latitude);

}  // namespace geomesh::geomodel
