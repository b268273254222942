// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/read_rules.hpp"

#include <algorithm>

namespace geomesh::geomodel {

namespace {

/// A length, area or volume of zero or more.
void read_measure(const YamlValue& value, double& measure) {
  const auto number = value.number();
  if (!number) return;
  if (*number < 0) value.problem("a number of zero or more was expected");
  measure = *number;
}

/// `as_given`, `to_box`, `to_fault NAME`, `to_horizon NAME`.
void read_extent(const YamlValue& value, SurfaceSpec& spec) {
  const auto text = value.text();
  if (!text) return;
  if (spec.kind != SurfaceKind::fault) return value.problem("only a fault has an extent; for other surfaces see 'extend'");
  if (*text == "as_given") {
    spec.rules.extend = Extend::none;
    return;
  }
  if (spec.rules.extend == Extend::none) spec.rules.extend = Extend::flat;
  if (*text == "to_box") return;
  for (const std::string word : {"to_fault ", "to_horizon "})
    if (text->rfind(word, 0) == 0 && text->size() > word.size()) {
      spec.rules.stop_at = text->substr(word.size());
      return;
    }
  value.problem("as_given, to_box, to_fault NAME or to_horizon NAME was expected");
}

}  // namespace

void read_surface_rules(const YamlMap& map, SurfaceSpec& spec) {
  if (const auto v = map.find("extend")) {
    const auto word = v->choice({"none", "flat", "tangent", "nearest"});
    spec.rules.extend = word == "flat" ? Extend::flat : word == "tangent" ? Extend::tangent : word == "nearest" ? Extend::nearest : Extend::none;
    if (spec.kind == SurfaceKind::body && spec.rules.extend != Extend::none)
      v->problem("a body is not extended: its open ends are closed beyond the box");
  }
  if (const auto v = map.find("fill_holes")) {
    if (v->scalar() == "all") {
      spec.rules.fill_holes = std::numeric_limits<double>::infinity();
    } else if (v->scalar() != "none") {
      read_measure(*v, spec.rules.fill_holes);
    }
  }
  if (const auto v = map.find("extent")) read_extent(*v, spec);
  if (const auto v = map.find("base")) {
    const auto word = v->choice({"conformable", "erode", "onlap"});
    spec.rules.base = word == "erode" ? BaseRule::erode : word == "onlap" ? BaseRule::onlap : BaseRule::conformable;
    if (spec.kind != SurfaceKind::horizon) v->problem("only a horizon is the base of a unit");
  }
}

void read_model_rules(const YamlValue& value, Project& project) {
  const YamlMap map(value, {"on_crossing", "trim_overshoot", "topography", "fault_blocks", "min_volume", "small_regions"});
  if (const auto v = map.find("on_crossing")) {
    const auto word = v->choice({"leave", "clip_younger", "clip_older", "error"});
    project.rules.on_crossing = word == "clip_younger" ? OnCrossing::clip_younger
                                : word == "clip_older" ? OnCrossing::clip_older
                                : word == "error"      ? OnCrossing::error
                                                       : OnCrossing::leave;
  }
  if (const auto v = map.find("trim_overshoot")) read_measure(*v, project.rules.trim_overshoot);
  if (const auto v = map.find("topography")) {
    project.naming.topography = v->text().value_or("");
    const bool known = std::any_of(project.surfaces.begin(), project.surfaces.end(), [&](const SurfaceSpec& s) {
      return s.name == project.naming.topography && s.kind == SurfaceKind::horizon;
    });
    if (!known) v->problem("a horizon was expected, but no horizon is named '" + project.naming.topography + "'");
  }
  if (const auto v = map.find("fault_blocks")) project.naming.fault_blocks = v->boolean().value_or(false);
  if (const auto v = map.find("min_volume")) read_measure(*v, project.naming.min_volume);
  if (const auto v = map.find("small_regions")) project.naming.merge_small = v->choice({"report", "merge"}) == "merge";
}

void read_region_seeds(const YamlValue& value, Project& project) {
  for (const YamlValue& item : value.items()) {
    const YamlMap map(item, {"name", "at"});
    if (!map.is_map()) continue;
    NamedPoint seed;
    if (const auto v = map.require("name", "each region needs a name")) seed.name = v->text().value_or("");
    if (const auto v = map.require("at", "[x, y, z] of a point inside")) seed.point = v->point().value_or(Vec3{});
    project.naming.seeds.push_back(std::move(seed));
  }
}

void read_groups(const YamlValue& value, Project& project) {
  for (const auto& [name, list] : named_entries(value, "NAME: [unit, unit, ...]"))
    for (const YamlValue& item : list.items())
      if (const auto unit = item.text()) project.naming.groups[name].push_back(*unit);
}

void read_attributes(const YamlValue& value, Project& project) {
  for (const auto& [unit, list] : named_entries(value, "UNIT: {NAME: number, ...}"))
    for (const auto& [name, number] : named_entries(list, "NAME: number")) {
      if (name == "region") number.problem("'region' is the name of the array of region ids; choose another");
      if (const auto n = number.number()) project.naming.attributes[unit][name] = *n;
    }
}

void finish_rules(const YamlValue& root, Project& project) {
  project.rules.column = project.column;
  project.rules.topography = project.naming.topography;
  project.rules.floor = project.naming.floor;
  project.naming.column = project.column;
  for (const SurfaceSpec& spec : project.surfaces) {
    project.rules.surfaces.push_back(spec.rules);
    if (spec.rules.extend != Extend::none && !project.box)
      root.problem("surface '" + spec.name + "' is to be extended to the box, and there is no box");
    if (spec.rules.stop_at.empty()) continue;
    const bool known = std::any_of(project.surfaces.begin(), project.surfaces.end(),
                                   [&](const SurfaceSpec& s) { return s.name == spec.rules.stop_at && s.name != spec.name; });
    if (!known) root.problem("surface '" + spec.name + "' is to end at '" + spec.rules.stop_at + "', which is no other surface");
  }
}

}  // namespace geomesh::geomodel
