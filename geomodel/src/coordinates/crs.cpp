// SPDX-License-Identifier: GPL-3.0-or-later
#include "coordinates/crs.hpp"

#include <GeographicLib/Constants.hpp>
#include <GeographicLib/PolarStereographic.hpp>
#include <GeographicLib/UTMUPS.hpp>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <optional>

#include "geomesh/core/error.hpp"
#include "readers/text/text.hpp"

namespace geomesh::geomodel {
namespace {

/// A polar stereographic coordinate system: latitude of true scale (or the scale at the pole), central meridian, false
/// easting and northing.
struct PolarSystem {
  int epsg;
  bool north;
  double true_latitude;  ///< latitude of true scale in degrees; 90 means UPS, whose scale at the pole is 0.994
  double meridian, false_origin;
};
constexpr PolarSystem polar_systems[] = {
    {32661, true, 90, 0, 2e6}, {5041, true, 90, 0, 2e6}, {32761, false, 90, 0, 2e6}, {5042, false, 90, 0, 2e6},
    {3413, true, 70, -45, 0},  {3995, true, 71, 0, 0},   {3031, false, 71, 0, 0},    {3976, false, 70, 0, 0},
};

const PolarSystem* polar_system(int epsg) {
  for (const PolarSystem& s : polar_systems)
    if (s.epsg == epsg) return &s;
  return nullptr;
}

GeographicLib::PolarStereographic projection(const PolarSystem& s) {
  using GeographicLib::Constants;
  GeographicLib::PolarStereographic p(Constants::WGS84_a(), Constants::WGS84_f(), Constants::UPS_k0());
  if (s.true_latitude < 90) p.SetScale(s.true_latitude);
  return p;
}

std::string squeezed(std::string_view text) {
  std::string out;
  for (const char c : to_lower(text))
    if (!std::isspace(static_cast<unsigned char>(c)) && c != '_' && c != '-') out += c;
  return out;
}

std::optional<HorizontalCrs> by_code(int code) {
  HorizontalCrs crs;
  crs.epsg = code;
  crs.kind = HorizontalCrs::Kind::utm;
  if (code == 4326 || code == 4258) {
    crs.kind = HorizontalCrs::Kind::geographic;
    crs.etrs89 = code == 4258;
  } else if (code > 32600 && code <= 32660) {
    crs.zone = code - 32600;
  } else if (code > 32700 && code <= 32760) {
    crs.zone = code - 32700;
    crs.north = false;
  } else if (code >= 25828 && code <= 25838) {
    crs.zone = code - 25800;
    crs.etrs89 = true;
  } else if (const PolarSystem* s = polar_system(code)) {
    crs.kind = HorizontalCrs::Kind::polar;
    crs.north = s->north;
  } else {
    return std::nullopt;
  }
  return crs;
}

/// Parses what follows "utm" in the name of a coordinate system: nothing, or a zone from 1 to 60 with N or S.
std::optional<HorizontalCrs> utm_of(std::string_view rest) {
  HorizontalCrs crs;
  crs.kind = HorizontalCrs::Kind::utm;
  if (rest.starts_with("zone")) rest.remove_prefix(4);
  if (rest.empty()) return crs;
  const char hemisphere = rest.back();
  const auto zone = to_integer(rest.substr(0, rest.size() - 1));
  if ((hemisphere != 'n' && hemisphere != 's') || !zone || *zone < 1 || *zone > 60) return std::nullopt;
  crs.zone = static_cast<int>(*zone);
  crs.north = hemisphere == 'n';
  return crs;
}

std::optional<int> epsg_code(std::string_view squeezed_text) {
  if (!squeezed_text.starts_with("epsg:")) return std::nullopt;
  const auto code = to_integer(squeezed_text.substr(5));
  return code && *code > 0 && *code < 1'000'000 ? std::optional(static_cast<int>(*code)) : std::nullopt;
}

[[noreturn]] void out_of_range(const HorizontalCrs& crs, const Vec2& p, const char* reason) {
  char place[80];
  std::snprintf(place, sizeof place, "(%.10g, %.10g)", p.x, p.y);
  throw Error(ErrorKind::invalid_input, std::string(place) + " is no place in " + crs.name() + ": " + reason);
}

}  // namespace

std::string HorizontalCrs::name() const {
  if (kind == Kind::utm && zone > 0) return "utm " + std::to_string(zone) + (north ? "N" : "S");
  if (kind == Kind::geographic) return "geographic";
  return text;
}

HorizontalCrs parse_crs(std::string_view text) {
  const std::string s = squeezed(text);
  std::optional<HorizontalCrs> crs;
  if (s == "local") crs = HorizontalCrs{};
  if (s == "geographic" || s == "lonlat" || s == "wgs84") {
    crs = HorizontalCrs{};
    crs->kind = HorizontalCrs::Kind::geographic;
  }
  if (s.starts_with("utm")) crs = utm_of(std::string_view(s).substr(3));
  if (const auto code = epsg_code(s)) crs = by_code(*code);
  if (!crs) {
    crs = HorizontalCrs{};
    crs->kind = HorizontalCrs::Kind::other;
    crs->epsg = epsg_code(s).value_or(0);
  }
  crs->text = text;
  return *crs;
}

std::string complaint_about_crs(std::string_view text) {
  const HorizontalCrs crs = parse_crs(text);
  if (crs.kind != HorizontalCrs::Kind::other || crs.epsg > 0) return {};
  return "local, geographic, utm, utm 32N (zone 1 to 60 with N or S) or epsg:CODE was expected, found " +
         in_quotes(text);
}

bool same_system(const HorizontalCrs& a, const HorizontalCrs& b) {
  if (a.kind != b.kind) return false;
  if (a.kind == HorizontalCrs::Kind::utm) return a.zone == b.zone && a.north == b.north;
  if (a.kind == HorizontalCrs::Kind::polar || a.kind == HorizontalCrs::Kind::other)
    return a.epsg == b.epsg && (a.epsg > 0 || a.text == b.text);
  return true;
}

Vec2 to_geographic(const HorizontalCrs& crs, const Vec2& p) {
  if (crs.kind == HorizontalCrs::Kind::geographic) {
    if (!(std::abs(p.y) <= 90) || !(std::abs(p.x) <= 540))
      out_of_range(crs, p, "x is a longitude and y a latitude in degrees");
    return p;
  }
  double latitude = 0, longitude = 0;
  try {
    if (const PolarSystem* s = polar_system(crs.epsg)) {
      projection(*s).Reverse(s->north, p.x - s->false_origin, p.y - s->false_origin, latitude, longitude);
      longitude = GeographicLib::Math::AngNormalize(longitude + s->meridian);
    } else {
      GeographicLib::UTMUPS::Reverse(crs.zone, crs.north, p.x, p.y, latitude, longitude);
    }
  } catch (const std::exception& e) {
    out_of_range(crs, p, e.what());
  }
  return {longitude, latitude};
}

Vec2 from_geographic(const HorizontalCrs& crs, const Vec2& p) {
  if (crs.kind == HorizontalCrs::Kind::geographic) return p;
  Vec2 q;
  try {
    if (const PolarSystem* s = polar_system(crs.epsg)) {
      projection(*s).Forward(s->north, p.y, GeographicLib::Math::AngNormalize(p.x - s->meridian), q.x, q.y);
      return {q.x + s->false_origin, q.y + s->false_origin};
    }
    int zone = 0;
    bool north = true;
    GeographicLib::UTMUPS::Forward(p.y, p.x, zone, north, q.x, q.y, crs.zone);
    if (north != crs.north)
      q.y += north ? 1e7 : -1e7;  // beyond the equator, UTM northings keep the false northing of the zone's hemisphere
  } catch (const std::exception& e) {
    out_of_range(crs, p, e.what());
  }
  return q;
}

HorizontalCrs utm_at(const Vec2& p) {
  HorizontalCrs crs;
  crs.kind = HorizontalCrs::Kind::utm;
  crs.zone = GeographicLib::UTMUPS::StandardZone(p.y, p.x, GeographicLib::UTMUPS::UTM);
  crs.north = p.y >= 0;
  crs.text = crs.name();
  return crs;
}

}  // namespace geomesh::geomodel
