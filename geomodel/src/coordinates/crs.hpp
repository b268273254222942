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
    local,       ///< coordinates whose position on the globe is unknown
    geographic,  ///< x is longitude, y is latitude, in degrees
    utm,         ///< UTM; zone 0 means that the zone is still to be determined
    polar,       ///< polar stereographic
    other,       ///< a coordinate system of which only the name is known
  };
  Kind kind = Kind::local;
  int zone = 0;
  bool north = true;
  int epsg = 0;  ///< EPSG code; 0 if the system was not given by a code
  /// Whether the datum is ETRS89 and not WGS84; the two are treated as equal (they differ by less than a metre).
  bool etrs89 = false;
  std::string text;  ///< as written

  bool converts() const { return kind == Kind::geographic || kind == Kind::utm || kind == Kind::polar; }
  /// Returns the name of the coordinate system: "utm 32N", "geographic", else the text as written.
  std::string name() const;
};

/// Parses "local", "geographic", "utm", "utm 32N" (also "UTM zone 32N", "utm32n"), "epsg:CODE"; case and blanks are
/// ignored. Any other text gives a system of kind `other`.
HorizontalCrs parse_crs(std::string_view text);
/// Returns what is wrong with the name of a coordinate system in a project; empty if nothing is.
std::string complaint_about_crs(std::string_view text);

/// Returns whether two horizontal coordinate systems are the same, apart from their datum.
bool same_system(const HorizontalCrs& a, const HorizontalCrs& b);

/// Converts a point to longitude and latitude in degrees. Throws Error{invalid_input} if the point is outside the
/// system's range. Precondition: crs.converts(), zone known. Accurate to a micrometre (Karney, "Transverse Mercator
/// with an accuracy of a few nanometers", J. Geodesy 85, 2011).
Vec2 to_geographic(const HorizontalCrs& crs, const Vec2& p);
/// Converts longitude and latitude to metres, or degrees for a geographic system. Precondition: crs.converts() and a
/// known zone. Throws Error{invalid_input} if the point is outside the range of the system.
Vec2 from_geographic(const HorizontalCrs& crs, const Vec2& longitude_latitude);

/// Returns the UTM system of the zone in which a place lies (with the exceptions around Norway and Svalbard).
HorizontalCrs utm_at(const Vec2& longitude_latitude);

}  // namespace geomesh::geomodel
