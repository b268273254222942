// SPDX-License-Identifier: GPL-3.0-or-later
// The keys gridding, resample and smooth of an entry of `surfaces`, declared in project/read_reading.hpp.
#include <cmath>

#include "project/read_reading.hpp"

namespace geomesh::geomodel {
namespace {

void read_length(const YamlValue& value, double& length) {
  const auto number = value.number();
  if (!number) return;
  if (*number <= 0) return value.problem("a length greater than zero was expected");
  length = *number;
}

void read_method(const YamlValue& value, SurfaceSpec& spec) {
  const YamlMap map(value, {"method", "spacing", "smoothing", "max_distance", "extent"});
  if (!map.is_map()) return;
  if (const auto v = map.find("method")) {
    if (v->choice({"thin_plate", "triangulate"}) == "triangulate")
      spec.gridding.method = GriddingSpec::Method::triangulate;
  }
  if (const auto v = map.find("spacing")) read_length(*v, spec.gridding.spacing);
  if (const auto v = map.find("smoothing")) read_length(*v, spec.gridding.smoothing);
  if (const auto v = map.find("max_distance")) read_length(*v, spec.gridding.max_distance);
  if (const auto v = map.find("extent")) {
    spec.gridding.to_box = v->choice({"data", "box"}) == "box";
    if (spec.gridding.to_box && !spec.may_be(SurfaceKind::horizon))
      v->problem("only a horizon is gridded over the box; a fault goes on by 'extent: to_box' of the surface");
  }
  if (spec.gridding.method == GriddingSpec::Method::triangulate) {
    for (const char* key : {"spacing", "smoothing", "extent"})
      if (const auto v = map.find(key)) v->problem("has no meaning where points are triangulated as they are");
  }
}

/// One length for all axes, or one for each.
std::optional<Vec3> read_spacing(const YamlValue& value) {
  std::optional<Vec3> spacing;
  if (value.is_list()) {
    spacing = value.point();
  } else if (const auto length = value.number()) {
    spacing = Vec3{*length, *length, *length};
  }
  if (spacing && !(spacing->x > 0 && spacing->y > 0 && spacing->z > 0))
    value.problem("lengths above zero were expected");
  return spacing;
}

void refuse_keys_of_files(const YamlMap& map) {
  for (const char* key : {"file", "object", "gridding", "resample", "smooth", "fault_polygons"})
    if (const auto v = map.find(key))
      v->problem("does not go with a field, whose surface follows from 'value' and the tolerance; leave it out");
  for (const char* key : {"crs", "unit", "z_unit", "z", "z_datum"})
    if (const auto v = map.find(key))
      v->problem("does not go with a field, which is in the coordinates of the project; leave it out");
}

}  // namespace

void read_gridding(const YamlMap& map, SurfaceSpec& spec) {
  if (const auto v = map.find("gridding")) read_method(*v, spec);
  if (const auto v = map.find("resample")) read_length(*v, spec.resample);
  if (const auto v = map.find("smooth")) {
    const auto n = v->number();
    if (!n) return;
    if (*n < 0 || *n > 1000 || *n != std::floor(*n))
      return v->problem("a whole number of passes from 0 to 1000 was expected");
    spec.smooth = static_cast<int>(*n);
  }
}

const std::vector<std::string_view>& level_set_keys() {
  static const std::vector<std::string_view> keys{"field", "value", "array", "origin", "spacing"};
  return keys;
}

void read_level_set(const YamlMap& map, const std::shared_ptr<FieldFunction>& function, SurfaceSpec& spec) {
  refuse_keys_of_files(map);
  LevelSetSpec& level_set = spec.level_set.emplace();
  level_set.function = function;
  if (const auto v = map.require("value", "the value that the field has on the surface"))
    level_set.value = v->number().value_or(0);
  if (const auto v = map.find("array")) level_set.array = v->text().value_or("");
  if (const auto v = map.find("origin")) level_set.origin = v->point();
  if (const auto v = map.find("spacing")) level_set.spacing = read_spacing(*v);
  const auto field = map.find("field");
  if (function && field) field->problem("a function was given for '" + spec.name + "' already; leave out one of them");
  const bool is_npy = field && field->scalar().ends_with(".npy");
  if (is_npy && !(level_set.origin && level_set.spacing))
    field->problem("an array of NumPy says nothing of its place; give 'origin' [x, y, z] and 'spacing'");
  for (const char* key : {"origin", "spacing"})
    if (const auto v = map.find(key); v && !is_npy) v->problem("goes with a field in a .npy file alone");
}

}  // namespace geomesh::geomodel
