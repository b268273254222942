// SPDX-License-Identifier: GPL-3.0-or-later
#include "coordinates/proj_conversion.hpp"

#include <cpl_error.h>
#include <ogr_spatialref.h>

#include <cstdio>

#include "geomesh/core/error.hpp"

namespace geomesh::geomodel {

namespace {

/// GDAL prints its errors unless told not to.
class Quiet {
 public:
  Quiet() {
    CPLPushErrorHandler(CPLQuietErrorHandler);
    CPLErrorReset();
  }
  ~Quiet() { CPLPopErrorHandler(); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;
  std::string reason() const {
    const std::string text = CPLGetLastErrorMsg();
    return text.empty() ? "no reason given" : text;
  }
};

int code_of(const HorizontalCrs& crs) {
  if (crs.epsg > 0) return crs.epsg;
  if (crs.kind == HorizontalCrs::Kind::utm) return (crs.north ? 32600 : 32700) + crs.zone;
  return crs.kind == HorizontalCrs::Kind::geographic ? 4326 : 0;
}

OGRSpatialReference reference(const HorizontalCrs& crs) {
  const Quiet quiet;
  OGRSpatialReference reference;
  if (reference.importFromEPSG(code_of(crs)) != OGRERR_NONE)
    throw Error(ErrorKind::usage, crs.name() + " is no system that PROJ knows: " + quiet.reason());
  reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return reference;
}

double metres(const OGRSpatialReference& reference) { return reference.IsProjected() ? reference.GetLinearUnits() : 1; }

std::string datum(const OGRSpatialReference& reference) {
  const char* const name = reference.GetAttrValue("DATUM");
  return name ? name : "an unnamed datum";
}

/// The datums that are within a metre of WGS84: not worth a word beyond that of docs/coordinates.md.
bool is_one_datum(const std::string& a, const std::string& b) {
  const auto is_global = [](const std::string& d) {
    return d.find("World_Geodetic_System_1984") == 0 || d.find("WGS_1984") == 0 ||
           d.find("European_Terrestrial_Reference_System_1989") == 0;
  };
  return a == b || (is_global(a) && is_global(b));
}

}  // namespace

bool is_geographic(const HorizontalCrs& crs) {
  if (crs.kind == HorizontalCrs::Kind::geographic) return true;
  if (crs.kind != HorizontalCrs::Kind::other || crs.epsg == 0) return false;
  const Quiet quiet;
  OGRSpatialReference reference;
  return reference.importFromEPSG(crs.epsg) == OGRERR_NONE && reference.IsGeographic();
}

ProjConversion::ProjConversion(const HorizontalCrs& from, const HorizontalCrs& to)
    : names_("from " + from.name() + " to " + to.name()) {
  const OGRSpatialReference a = reference(from), b = reference(to);
  const Quiet quiet;
  OGRCoordinateTransformationOptions options;
  options.SetBallparkAllowed(false);  // a datum that is passed over is hundreds of metres
  transformation_.reset(OGRCreateCoordinateTransformation(&a, &b, options));
  if (!transformation_) throw Error(ErrorKind::usage, "PROJ knows no way " + names_ + ": " + quiet.reason());
  from_metres_ = metres(a);
  to_metres_ = metres(b);
  if (!is_one_datum(datum(a), datum(b)))
    datum_shift_ = "; datum shift from " + datum(a) + " to " + datum(b) + " by PROJ";
}

ProjConversion::~ProjConversion() = default;

Vec2 ProjConversion::convert(const Vec2& p) const {
  const Quiet quiet;
  double x = p.x / from_metres_, y = p.y / from_metres_;
  if (transformation_->Transform(1, &x, &y)) return {x * to_metres_, y * to_metres_};
  char place[80];
  std::snprintf(place, sizeof place, "(%.10g, %.10g)", p.x, p.y);
  throw Error(ErrorKind::invalid_input, std::string(place) + " cannot be converted " + names_ + ": " + quiet.reason());
}

}  // namespace geomesh::geomodel
