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
  /// Returns "utm 32N", "geographic", or the name as written.
  std::string name() const;
};

/// Parses "local", "geographic", "utm", "utm 32N" (also "UTM zone 32N", "utm32n"), "epsg:CODE", ignoring case and
/// blanks. Any other text is of kind other.
HorizontalCrs parse_crs(std::string_view text);
/// Says why such a text is wrong in a project, or returns an empty text.
std::string complaint_about_crs(std::string_view text);

/// Returns whether both are the same system, up to the datum.
bool same_system(const HorizontalCrs& a, const HorizontalCrs& b);

/// Returns longitude and latitude in degrees. Throws Error{invalid_input} if the point is beyond the system's range.
/// Precondition: crs.converts(), zone known. Accurate to a micrometre (Karney, "Transverse Mercator with an accuracy of
/// a few nanometers", J. Geodesy 85, 2011).
Vec2 to_geographic(const HorizontalCrs& crs, const Vec2& p);
/// Returns metres, or degrees. Errors and precondition as above.
Vec2 from_geographic(const HorizontalCrs& crs, const Vec2& longitude_latitude);

/// Returns the UTM system of the zone of a place (with the exceptions near Norway and Svalbard).
HorizontalCrs utm_at(const Vec2& longitude_latitude);

}  // namespace geomesh::geomodel
