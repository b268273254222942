// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/read_volume.hpp"

#include <algorithm>

namespace geomesh::geomodel {
namespace {

std::optional<Vec2> read_pair(const YamlValue& value, const char* what) {
  const std::vector<YamlValue> items = value.is_list() ? value.items() : std::vector<YamlValue>{};
  if (items.size() != 2) {
    value.problem(std::string("two numbers ") + what + " were expected");
    return std::nullopt;
  }
  const auto x = items[0].number(), y = items[1].number();
  if (!x || !y) return std::nullopt;
  return Vec2{*x, *y};
}

bool read_corners(const YamlMap& map, VolumeSpec& spec) {
  const auto min = map.require("min", "[x, y, z] of the box's lower corner");
  const auto max = map.require("max", "[x, y, z] of the box's upper corner");
  bool complete = true;
  const auto read_corner = [&](const std::optional<YamlValue>& value, Vec3& corner) {
    const auto p = value ? value->point() : std::nullopt;
    complete = complete && p.has_value();
    corner = p.value_or(Vec3{});
  };
  read_corner(min, spec.box.min);
  read_corner(max, spec.box.max);
  if (!complete) return false;
  for (std::size_t i = 0; i < 3; ++i)
    if (!(spec.box.min[i] < spec.box.max[i]))
      max->problem(std::string("the box is empty in ") + "xyz"[i] + ": max must be greater than min");
  return true;
}

bool read_margin(const YamlValue& value, VolumeSpec& spec) {
  if (value.is_list()) {
    const auto margin = value.point();
    if (!margin) return false;
    spec.margin = *margin;
  } else {
    const auto margin = value.number();
    if (!margin) return false;
    spec.margin = {*margin, *margin, *margin};
  }
  if (spec.margin.x < 0 || spec.margin.y < 0 || spec.margin.z < 0)
    value.problem("a length of zero or more was expected");
  return true;
}

bool read_polygon(const YamlValue& value, VolumeSpec& spec) {
  for (const YamlValue& item : value.items())
    if (const auto corner = read_pair(item, "[x, y]")) spec.polygon.push_back(*corner);
  if (spec.polygon.size() > 1 && spec.polygon.front().x == spec.polygon.back().x &&
      spec.polygon.front().y == spec.polygon.back().y)
    spec.polygon.pop_back();  // drop the last corner: many programs repeat the first one
  if (value.is_list() && spec.polygon.size() < 3) value.problem("at least three corners [x, y] were expected");
  return true;
}

bool read_turned(const YamlMap& map, VolumeSpec& spec) {
  const auto center = map.require("center", "[x, y] of the middle of the turned box");
  const auto size = map.require("size", "[length, length] along the box's own x and y");
  const auto c = center ? read_pair(*center, "[x, y]") : std::nullopt,
             s = size ? read_pair(*size, "[length, length]") : std::nullopt;
  if (!c || !s) return false;
  spec.center = *c;
  spec.size = *s;
  if (!(s->x > 0 && s->y > 0)) size->problem("lengths greater than zero were expected");
  return true;
}

/// Reads the top or bottom of a volume: a height, or the name of a horizon.
void read_end(const YamlMap& map, const char* key, std::optional<double>& height, std::string& surface) {
  const auto value = map.find(key);
  if (!value) return;
  const std::string text = value->scalar();
  if (!text.empty() && text.find_first_not_of("0123456789.+-eE") == std::string::npos) {
    height = value->number();
  } else {
    surface = value->text().value_or("");
  }
}

/// The keys that describe each shape of the model volume; the first key identifies the shape.
struct ShapeKeys {
  VolumeSpec::Shape shape;
  std::vector<std::string_view> keys;
};
const std::vector<ShapeKeys> shapes{{VolumeSpec::Shape::box, {"min", "max"}},
                                    {VolumeSpec::Shape::margin, {"margin", "azimuth", "bottom", "top"}},
                                    {VolumeSpec::Shape::turned, {"center", "size", "azimuth", "bottom", "top"}},
                                    {VolumeSpec::Shape::polygon, {"polygon", "bottom", "top"}}};

const ShapeKeys* shape_of(const YamlMap& map, const YamlValue& value) {
  for (const ShapeKeys& shape : shapes)
    for (std::size_t k = 0;
         k < (shape.shape == VolumeSpec::Shape::box || shape.shape == VolumeSpec::Shape::turned ? 2u : 1u); ++k)
      if (map.find(shape.keys[k])) return &shape;
  value.problem(
      "one of these was expected: min and max (corners); margin (about the data); center and size (a turned box); "
      "polygon");
  return nullptr;
}

}  // namespace

std::optional<VolumeSpec> read_volume(const YamlValue& value) {
  const std::vector<std::string_view> known{"min",     "max",     "margin", "center", "size",
                                            "polygon", "azimuth", "bottom", "top"};
  if (!value.is_map()) {
    value.problem(
        "min and max were expected: box: {min: [x, y, z], max: [x, y, z]}; other shapes are given by margin, center or "
        "polygon");
    return std::nullopt;
  }
  const YamlMap map(value, known);
  const ShapeKeys* shape = shape_of(map, value);
  if (!shape) return std::nullopt;
  for (const std::string_view key : known)
    if (map.find(key) && std::find(shape->keys.begin(), shape->keys.end(), key) == shape->keys.end())
      map.find(key)->problem("does not go with " + std::string(shape->keys[0]) + "; allowed with it are " +
                             listed(shape->keys));
  VolumeSpec spec;
  spec.shape = shape->shape;
  bool complete = false;
  switch (spec.shape) {
    case VolumeSpec::Shape::box:
      complete = read_corners(map, spec);
      break;
    case VolumeSpec::Shape::margin:
      complete = read_margin(*map.find("margin"), spec);
      break;
    case VolumeSpec::Shape::turned:
      complete = read_turned(map, spec);
      break;
    case VolumeSpec::Shape::polygon:
      complete = read_polygon(*map.find("polygon"), spec);
      break;
  }
  if (const auto v = map.find("azimuth")) spec.azimuth = v->number().value_or(0);
  read_end(map, "bottom", spec.bottom, spec.bottom_surface);
  read_end(map, "top", spec.top, spec.top_surface);
  if (spec.shape == VolumeSpec::Shape::turned || spec.shape == VolumeSpec::Shape::polygon) {
    map.require("bottom", "a height, or the horizon at which the model ends below");
    map.require("top", "a height, or the horizon at which the model ends above");
  }
  return complete ? std::optional(spec) : std::nullopt;
}

void finish_volume(const YamlValue& root, Project& project) {
  if (!project.box) return;
  const std::optional<double>&bottom = project.box->bottom, &top = project.box->top;
  if (bottom && top && !(project.crs.depth ? *top < *bottom : *bottom < *top))
    root.problem(std::string("box: its bottom must be below its top (") +
                 (project.crs.depth ? "depths count downwards)" : "heights count upwards)"));
  const auto check = [&](const std::string& name, const char* key) {
    if (name.empty()) return;
    const bool known = std::any_of(project.surfaces.begin(), project.surfaces.end(), [&](const SurfaceSpec& s) {
      return s.name == name && s.may_be(SurfaceKind::horizon);
    });
    if (!known)
      root.problem(std::string("box.") + key + ": a height or a horizon was expected, but no horizon is named '" +
                   name + "'");
  };
  check(project.box->bottom_surface, "bottom");
  check(project.box->top_surface, "top");
  if (!project.box->top_surface.empty()) {
    if (!project.naming.topography.empty() && project.naming.topography != project.box->top_surface)
      root.problem("box.top is " + project.box->top_surface + ", but rules.topography is " + project.naming.topography +
                   ": give one of them");
    project.naming.topography = project.box->top_surface;
  }
  project.naming.floor = project.box->bottom_surface;
}

}  // namespace geomesh::geomodel
