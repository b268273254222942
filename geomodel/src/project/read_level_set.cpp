// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/read_level_set.hpp"

namespace geomesh::geomodel {
namespace {

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
