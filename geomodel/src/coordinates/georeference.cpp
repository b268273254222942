// SPDX-License-Identifier: GPL-3.0-or-later
#include "coordinates/georeference.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "coordinates/proj_conversion.hpp"
#include "geomesh/core/error.hpp"
#include "readers/text/frame.hpp"
#include "readers/text/units.hpp"

namespace geomesh::geomodel {
namespace {

using Kind = HorizontalCrs::Kind;

template <class Function>
void for_each_point(FileContents& contents, const Function& f) {
  for (TriangulatedSurface& s : contents.surfaces) std::for_each(s.points.begin(), s.points.end(), f);
  for (Polyline& l : contents.polylines) std::for_each(l.points.begin(), l.points.end(), f);
  for (PointSet& s : contents.point_sets) std::for_each(s.points.begin(), s.points.end(), f);
  for (NamedPoint& p : contents.points) f(p.point);
}

Box3 bounds_of(FileContents& contents) {
  Box3 bounds;
  for_each_point(contents, [&](Vec3& p) { bounds.add(p); });
  return bounds;
}

std::string range_text(const Box3& b) {
  char text[160];
  std::snprintf(text, sizeof text, "x %.8g to %.8g, y %.8g to %.8g", b.min.x, b.max.x, b.min.y, b.max.y);
  return text;
}

bool is_named(const std::string& unit) {
  return !unit.empty() && !equals_ignoring_case(unit, "none") && !equals_ignoring_case(unit, "unknown") &&
         !equals_ignoring_case(unit, "unitless");
}
double metres_of(const std::string& unit) { return is_named(unit) ? length_unit_in_metres(unit).value_or(1) : 1; }

/// Returns the unit that a file names for z, or for x and y; empty if it names none.
std::string own_unit(const SourceFrame& frame, bool z) {
  const std::string& unit = z && is_named(frame.z_unit) ? frame.z_unit : frame.unit;
  return is_named(unit) ? unit : std::string();
}

/// Returns whether a box's x and y can only be degrees, because projected systems have no places so near their origin.
bool looks_like_degrees(const Box3& b) { return b.min.x >= -360 && b.max.x <= 360 && b.min.y >= -90 && b.max.y <= 90; }

}  // namespace

ModelFrame::ModelFrame(const Project& project, const std::vector<SourceInput>& inputs)
    : given_(parse_crs(project.crs.horizontal)),
      system_(given_),
      unit_(project.crs.unit),
      metres_(metres_of(project.crs.unit)),
      depth_(project.crs.depth),
      origin_(project.output.origin) {
  const bool open = given_.kind == Kind::geographic || (given_.kind == Kind::utm && given_.zone == 0);
  if (!open) return;
  if (given_.kind == Kind::geographic && project.box && project.box->shape == VolumeSpec::Shape::box) {
    const Vec3 centre = 0.5 * (project.box->box.min + project.box->box.max);
    system_ = utm_at(to_geographic(given_, {centre.x, centre.y}));
    return;
  }
  for (const SourceInput& input : inputs) {
    std::vector<std::string> unused;
    if (system_of(input, unused).kind != Kind::geographic) continue;
    const Box3 bounds = bounds_of(*input.contents);
    if (bounds.empty()) continue;
    system_ = utm_at(to_geographic(parse_crs("geographic"),
                                   {0.5 * (bounds.min.x + bounds.max.x), 0.5 * (bounds.min.y + bounds.max.y)}));
    return;
  }
  throw Error(
      ErrorKind::usage,
      project.file.filename().string() + ": crs.horizontal is " + project.crs.horizontal +
          ", whose zone is found from inputs in longitude and latitude, and there is none; name the zone (utm 32N)");
}

HorizontalCrs ModelFrame::system_of(const SourceInput& input, std::vector<std::string>& notes) const {
  if (!input.spec->crs.empty()) return parse_crs(input.spec->crs);
  const SourceFrame& frame = input.contents->frame;
  if (frame.geographic) return parse_crs("geographic");
  const HorizontalCrs own = parse_crs(frame.crs);
  if (own.epsg > 0 && given_.kind != Kind::local) return own;
  if (!frame.crs.empty() && frame.crs != given_.text) {
    notes.push_back(input.name + ": the file names its system '" + frame.crs +
                    "'; its coordinates are taken for those of the project (" + given_.text + ") as they are");
  }
  return given_;
}

Vec2 ModelFrame::to_system(const HorizontalCrs& from, const Vec2& p) const {
  return same_system(from, system_) ? p : from_geographic(system_, to_geographic(from, p));
}

void ModelFrame::check_range(const SourceInput& input, const HorizontalCrs& from) const {
  const Box3 bounds = bounds_of(*input.contents);
  if (bounds.empty()) return;
  if (from.kind == Kind::other && is_geographic(from)) return;  // PROJ reports coordinates outside a system's range
  const bool projected =
      from.kind == Kind::utm || from.kind == Kind::polar || (from.kind == Kind::other && from.epsg > 0);
  if (projected && looks_like_degrees(bounds)) {
    throw Error(ErrorKind::invalid_input, input.name + ": its coordinates (" + range_text(bounds) +
                                              ") look like longitude and latitude, but are to be " + from.name() +
                                              "; if they are degrees, add 'crs: geographic' to this entry");
  }
  if (from.kind == Kind::geographic &&
      (std::abs(bounds.min.y) > 90 || std::abs(bounds.max.y) > 90 || bounds.min.x < -360 || bounds.max.x > 360)) {
    throw Error(ErrorKind::invalid_input, input.name + ": its coordinates (" + range_text(bounds) +
                                              ") are to be longitude and latitude in degrees, which they cannot be; " +
                                              (std::abs(bounds.min.x) <= 90 && std::abs(bounds.max.x) <= 90 &&
                                                       std::abs(bounds.min.y) <= 360 && std::abs(bounds.max.y) <= 360
                                                   ? "exchanged they could: is x the latitude? If so, give columns: "
                                                     "{longitude: 2, latitude: 1, z: 3} in its entry"
                                                   : "name their system with 'crs: utm 32N' or the like"));
  }
}

void ModelFrame::refuse_exchanged_degrees(const SourceInput& input, const HorizontalCrs& from) const {
  const Box3 bounds = bounds_of(*input.contents);
  if (bounds.empty() || from.kind != Kind::geographic || system_.kind != Kind::utm || system_.zone == 0) return;
  // Degrees of longitude from the middle of a UTM zone beyond which the projection is useless.
  constexpr double far = 40;
  constexpr double near = 15;  // models lie in their UTM zone, which is 6 degrees wide, or beside it
  const double middle = 6.0 * system_.zone - 183;
  const auto off = [&](double longitude) { return std::abs(std::remainder(longitude - middle, 360)); };
  const double centre_x = 0.5 * (bounds.min.x + bounds.max.x), centre_y = 0.5 * (bounds.min.y + bounds.max.y);
  if (off(centre_x) <= far) return;
  const bool exchanged = off(centre_y) <= near && std::abs(centre_x) <= 90 && (centre_x >= 0) == system_.north;
  throw Error(
      ErrorKind::invalid_input,
      input.name + ": its longitudes and latitudes (" + range_text(bounds) + ") lie " +
          std::to_string(static_cast<int>(off(centre_x))) + " degrees from the middle of " + system_.name() +
          (exchanged ? "; exchanged they would lie in it: is x the latitude? If so, name the columns in its entry "
                       "(columns: {longitude: 2, latitude: 1, z: 3}), or export the file again with longitude "
                       "first"
                     : "; is the zone right (crs: {horizontal: ...}), and are these degrees?"));
}

/// Returns the conversion from an input's coordinate system to the model's if it needs PROJ; nothing if GeographicLib
/// supports it, or if there is nothing to convert.
std::optional<ProjConversion> ModelFrame::proj_between(const SourceInput& input, const HorizontalCrs& from) const {
  if (same_system(from, system_) || (from.converts() && system_.converts())) return std::nullopt;
  const HorizontalCrs& stranger = from.converts() ? system_ : from;
  const std::string what =
      input.name + ": its coordinates are " + from.name() + ", those of the project " + system_.name();
  if (stranger.kind == Kind::local)
    throw Error(ErrorKind::usage,
                what +
                    ", and a local system has no place on the globe; convert the file first (ogr2ogr, "
                    "gdalwarp, cs2cs), or name another system for the project");
  try {
    return std::optional<ProjConversion>(std::in_place, from, system_);
  } catch (const Error& error) {
    throw Error(error.kind(), what + ", and " + error.what() + "; convert the file first (ogr2ogr, gdalwarp, cs2cs)");
  }
}

void ModelFrame::place(const SourceInput& input, std::vector<std::string>& notes,
                       std::vector<std::string>& warnings) const {
  FileContents& contents = *input.contents;
  const SourceSpec& spec = *input.spec;
  const HorizontalCrs from = system_of(input, notes);
  const bool converts = !same_system(from, system_);
  const std::optional<ProjConversion> proj = proj_between(input, from);
  const std::string own_xy = own_unit(contents.frame, false), own_z = own_unit(contents.frame, true);
  const auto wanted = [&](const std::string& asked, const std::string& own) {
    return !asked.empty() ? asked : !own.empty() ? own : unit_;
  };
  const std::string xy_unit = wanted(spec.unit, own_xy),
                    z_unit = wanted(!spec.z_unit.empty() ? spec.z_unit : spec.unit, own_z);
  const bool depth = spec.depth.value_or(contents.frame.z_named ? contents.frame.depth : depth_);
  if (!own_z.empty() && metres_of(own_z) != metres_of(z_unit))
    warnings.push_back(input.name + ": the file says z is in " + own_z + "; taken as " + z_unit +
                       " as the project says");
  if (contents.frame.z_named && depth != contents.frame.depth) {
    warnings.push_back(input.name + ": the file says z is " + (contents.frame.depth ? "depth" : "elevation") +
                       "; taken as " + (depth ? "depth" : "elevation") + " as the project says");
  }
  // The reader of the file has applied the units that the file names. `scale` has the factors from there to the units
  // of the project's keys, with elevation up.
  AxisScale scale{metres_of(xy_unit) / metres_of(own_xy), metres_of(z_unit) / metres_of(own_z)};
  if (is_geographic(from)) scale.xy = 1;
  if (depth != contents.frame.depth) scale.z = -scale.z;
  scale_contents(contents, scale);
  check_range(input, from);
  refuse_exchanged_degrees(input, from);
  for_each_point(contents, [&](Vec3& p) {
    const Vec2 q = proj ? proj->convert({p.x, p.y}) : converts ? to_system(from, {p.x, p.y}) : Vec2{p.x, p.y};
    p = Vec3{q.x / metres_, q.y / metres_, p.z / metres_ + spec.z_datum} - origin_;
  });
  if (converts)
    notes.push_back(input.name + ": converted from " + from.name() + " to " + system_.name() +
                    (proj ? proj->datum_shift()
                     : from.etrs89 != system_.etrs89
                         ? " (WGS84 and ETRS89 taken for one; they are less than a metre apart)"
                         : ""));
  if (xy_unit != unit_ && !is_geographic(from))
    notes.push_back(input.name + ": x and y converted from " + xy_unit + " to " + unit_);
  if (z_unit != unit_) notes.push_back(input.name + ": z converted from " + z_unit + " to " + unit_);
  if (depth) notes.push_back(input.name + ": z is depth, negated");
  if (spec.z_datum != 0) {
    char text[64];
    std::snprintf(text, sizeof text, "%.6g %s", spec.z_datum, unit_.c_str());
    notes.push_back(input.name + ": its zero of z lies at an elevation of " + text);
  }
}

Vec3 ModelFrame::point(const Vec3& p) const {
  Vec2 q{p.x, p.y};
  if (given_.kind == Kind::geographic) {
    q = to_system(given_, q);
    q = {q.x / metres_, q.y / metres_};
  }
  return Vec3{q.x, q.y, depth_ ? -p.z : p.z} - origin_;
}

Box3 ModelFrame::box(const Box3& box, std::string& note) const {
  Box3 placed{point(box.min), point(box.max)};
  if (depth_) std::swap(placed.min.z, placed.max.z);
  if (given_.kind == Kind::geographic) {
    constexpr int n_samples = 64;  // points along each side: sides of a box in degrees curve on the map
    for (int i = 0; i <= n_samples; ++i) {
      const double t = static_cast<double>(i) / n_samples;
      const double x = box.min.x + t * (box.max.x - box.min.x), y = box.min.y + t * (box.max.y - box.min.y);
      placed.min.x = std::max(placed.min.x, point({box.min.x, y, 0}).x);
      placed.max.x = std::min(placed.max.x, point({box.max.x, y, 0}).x);
      placed.min.y = std::max(placed.min.y, point({x, box.min.y, 0}).y);
      placed.max.y = std::min(placed.max.y, point({x, box.max.y, 0}).y);
    }
    if (!(placed.min.x < placed.max.x) || !(placed.min.y < placed.max.y)) {
      throw Error(ErrorKind::usage, "box: no upright rectangle of " + system_.name() +
                                        " lies inside these longitudes and latitudes; give surfaces and box in " +
                                        system_.name());
    }
    Box3 told = placed;
    told.min = told.min + origin_;
    told.max = told.max + origin_;
    note = "the box in longitude and latitude becomes the largest upright rectangle inside it in " + system_.name() +
           ": " + range_text(told);
  }
  return placed;
}

Vec2 ModelFrame::map_point(const Vec2& p) const {
  const Vec3 q = point({p.x, p.y, 0});
  return {q.x, q.y};
}

VolumeSpec ModelFrame::volume(const VolumeSpec& spec, std::string& note) const {
  VolumeSpec placed = spec;
  if (spec.shape == VolumeSpec::Shape::box) placed.box = box(spec.box, note);
  if (spec.shape == VolumeSpec::Shape::turned) placed.center = map_point(spec.center);
  for (Vec2& corner : placed.polygon) corner = map_point(corner);
  for (std::optional<double>* height : {&placed.bottom, &placed.top})
    if (*height) **height = ((depth_ ? -**height : **height) - origin_.z);
  return placed;
}

}  // namespace geomesh::geomodel
