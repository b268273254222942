// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/read_rules.hpp"

#include <algorithm>

namespace geomesh::geomodel {

namespace {

/// Reads a length, area or volume that is not negative.
void read_measure(const YamlValue& value, double& measure) {
  const auto number = value.number();
  if (!number) return;
  if (*number < 0) value.problem("a number of zero or more was expected");
  measure = *number;
}

std::vector<std::string> read_names(const YamlValue& value) {
  std::vector<std::string> names;
  for (const YamlValue& item : value.items())
    if (const auto name = item.text()) names.push_back(*name);
  return names;
}

/// Reads the extent of a surface: `as_given`, `to_box`, `to_fault NAME` or `to_horizon NAME`.
void read_extent(const YamlValue& value, SurfaceSpec& spec) {
  const auto text = value.text();
  if (!text) return;
  if (!spec.may_be(SurfaceKind::fault))
    return value.problem("only a fault has an extent; for other surfaces see 'extend'");
  if (*text == "as_given") {
    spec.rules.extend = Extend::none;
    spec.rules.continues = false;
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

const std::vector<std::string_view>& surface_rule_keys() {
  static const std::vector<std::string_view> keys{"cuts", "extend",   "fill_holes", "extent",
                                                  "base", "throw_at", "thickness",  "smeared_throw"};
  return keys;
}

void read_surface_rules(const YamlMap& map, SurfaceSpec& spec) {
  if (const auto v = spec.below.empty() ? map.find("thickness") : std::nullopt) {
    read_measure(*v, spec.rules.thickness);
    if (!spec.may_be(SurfaceKind::body))
      v->problem("only a body has a thickness: a dyke or sill, given as a sheet; a horizon has it together with below");
    if (!(spec.rules.thickness > 0)) v->problem("a number above zero was expected");
  }
  if (const auto v = map.find("extend")) {
    const auto word = v->choice({"none", "flat", "tangent", "nearest"});
    spec.rules.extend = word == "flat"      ? Extend::flat
                        : word == "tangent" ? Extend::tangent
                        : word == "nearest" ? Extend::nearest
                                            : Extend::none;
    spec.rules.continues = word != "none";
    if (spec.kind == SurfaceKind::body && spec.rules.extend != Extend::none && spec.rules.thickness == 0)
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
  if (const auto v = map.find("throw_at")) {
    spec.rules.throw_auto = v->scalar() == "auto";
    if (!spec.rules.throw_auto) spec.rules.throw_at = read_names(*v);
    if (!spec.may_be(SurfaceKind::horizon))
      v->problem("only a horizon has throw; name the faults at the horizons that they displace");
  }
  if (const auto v = map.find("smeared_throw")) {
    spec.rules.cut_smeared = v->choice({"cut", "keep"}) != "keep";
    if (!spec.rules.throw_auto && spec.rules.throw_at.empty())
      v->problem("it is allowed with throw_at, which names the faults across which the horizon has throw");
  }
  if (const auto v = map.find("base")) {
    const auto word = v->choice({"conformable", "erode", "onlap"});
    spec.rules.base = word == "erode" ? BaseRule::erode : word == "onlap" ? BaseRule::onlap : BaseRule::conformable;
    if (!spec.may_be(SurfaceKind::horizon)) v->problem("only a horizon is the base of a unit");
  }
}

void read_cuts(const YamlValue& value, SurfaceSpec& spec) {
  if (spec.kind == SurfaceKind::fault && value.is_list()) {
    spec.rules.cut_units = read_names(value);
    if (spec.rules.cut_units.empty()) value.problem("the list of units is empty");
    return;
  }
  const auto cuts = value.choice({"all", "none"});
  if (cuts == "all" && spec.kind == SurfaceKind::horizon)
    value.problem("only bodies and faults cut; this surface is a horizon");
  if (cuts == "none" && spec.kind == SurfaceKind::fault)
    value.problem("all or a list of units of the column was expected");
  if (spec.kind == SurfaceKind::body && cuts) spec.cuts_all = cuts == "all";
}

void read_model_rules(const YamlValue& value, Project& project) {
  const YamlMap map(value, {"on_crossing", "trim_overshoot", "topography", "fault_blocks", "min_volume",
                            "small_regions", "min_thickness", "thin_layers", "stack", "continue_within"});
  if (const auto v = map.find("on_crossing")) {
    const auto word = v->choice({"leave", "clip_younger", "clip_older", "error"});
    project.rules.on_crossing = word == "clip_younger" ? OnCrossing::clip_younger
                                : word == "clip_older" ? OnCrossing::clip_older
                                : word == "error"      ? OnCrossing::error
                                                       : OnCrossing::leave;
  }
  if (const auto v = map.find("trim_overshoot")) read_measure(*v, project.rules.trim_overshoot);
  if (const auto v = map.find("continue_within")) read_measure(*v, project.rules.continue_within);
  if (const auto v = map.find("topography")) {
    project.naming.topography = v->text().value_or("");
    const bool known = std::any_of(project.surfaces.begin(), project.surfaces.end(), [&](const SurfaceSpec& s) {
      return s.name == project.naming.topography && s.may_be(SurfaceKind::horizon);
    });
    if (!known) v->problem("a horizon was expected, but no horizon is named '" + project.naming.topography + "'");
  }
  if (const auto v = map.find("fault_blocks")) project.naming.fault_blocks = v->boolean().value_or(false);
  if (const auto v = map.find("min_volume")) read_measure(*v, project.naming.min_volume);
  if (const auto v = map.find("min_thickness")) read_measure(*v, project.rules.min_thickness);
  if (const auto v = map.find("stack"))
    project.rules.stack.rule = v->choice({"auto", "keep"}) == "keep" ? StackRule::keep : StackRule::automatic;
  if (const auto v = map.find("thin_layers")) {
    const auto word = v->choice({"keep", "collapse", "error"});
    project.rules.thin_layers = word == "collapse" ? ThinLayers::collapse
                                : word == "error"  ? ThinLayers::error
                                                   : ThinLayers::keep;
  }
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
      const std::vector<std::string>& taken = known_cell_arrays();
      if (name == "region" || std::find(taken.begin(), taken.end(), name) != taken.end())
        number.problem("'" + name +
                       "' is the name of an array of the mesh file (mesh.cell_arrays, region ids); choose another");
      if (const auto n = number.number()) project.naming.attributes[unit][name] = *n;
    }
}

namespace {

std::optional<Colour> read_colour(const YamlValue& value) {
  constexpr const char* expected =
      "a colour was expected, as \"#e5c07b\" (in quotes: what follows a # is a comment), orange or [229, 192, 123]";
  if (!value.is_list()) {
    const auto colour = colour_from(value.scalar());
    if (!colour) value.problem(expected);
    return colour;
  }
  Colour colour{};
  const auto items = value.items();
  for (std::size_t k = 0; k < items.size() && k < colour.size(); ++k) {
    const auto channel = items[k].number();
    if (!channel) return {};
    colour[k] = *channel / 255;
  }
  const bool in_range = std::all_of(colour.begin(), colour.end(), [](double c) { return c >= 0 && c <= 1; });
  if (items.size() == colour.size() && in_range) return colour;
  value.problem(std::string(expected) + ", three numbers from 0 to 255");
  return {};
}

}  // namespace

void read_colours(const YamlValue& value, Project& project) {
  std::vector<std::string_view> known(project.column.begin(), project.column.end());
  for (const SurfaceSpec& s : project.surfaces) known.push_back(s.name);
  for (const NamedPoint& seed : project.naming.seeds) known.push_back(seed.name);
  for (const auto& [name, colour] : named_entries(value, "UNIT or SURFACE: colour")) {
    const std::string unit = unit_of_part(name.substr(0, name.find(".zone")));
    const bool is_known = std::find(known.begin(), known.end(), unit) != known.end();
    // Without a stratigraphic column, names of regions are not known yet and cannot be checked here.
    if (!is_known && !project.column.empty())
      colour.problem("no unit, body or surface is named '" + unit + "'" + was_meant(unit, known));
    if (const auto c = read_colour(colour)) project.colours[name] = *c;
  }
}

namespace {

/// Checks that the units which a fault cuts are consecutive in the stratigraphic column.
void check_units(const YamlValue& root, const Project& project, const SurfaceSpec& spec) {
  std::vector<std::size_t> rows;
  for (const std::string& unit : spec.rules.cut_units) {
    const auto at = std::find(project.column.begin(), project.column.end(), unit);
    const auto row = static_cast<std::size_t>(at - project.column.begin());
    if (at == project.column.end() || row % 2 == 1) {
      std::vector<std::string_view> units;
      for (std::size_t i = 0; i < project.column.size(); i += 2) units.push_back(project.column[i]);
      return root.problem("fault '" + spec.name + "' is to cut '" + unit +
                          "', which is no unit of the column; units are " + (units.empty() ? "none" : listed(units)));
    }
    rows.push_back(row / 2);
  }
  std::sort(rows.begin(), rows.end());
  for (std::size_t k = 1; k < rows.size(); ++k)
    if (rows[k] != rows[k - 1] + 1)
      return root.problem("the units that fault '" + spec.name +
                          "' cuts do not follow each other in the column; it cannot end and begin again");
}

void check_throw(const YamlValue& root, const Project& project, const SurfaceSpec& spec) {
  if (spec.rules.has_throw() && !project.box)
    root.problem("horizon '" + spec.name +
                 "' is to be continued to its faults (throw_at, fault_polygons), which needs a box");
  for (const std::string& name : spec.rules.throw_at) {
    const bool known = std::any_of(project.surfaces.begin(), project.surfaces.end(), [&](const SurfaceSpec& s) {
      return s.name == name && s.may_be(SurfaceKind::fault);
    });
    if (known) continue;
    std::vector<std::string_view> faults;
    for (const SurfaceSpec& s : project.surfaces)
      if (s.may_be(SurfaceKind::fault)) faults.push_back(s.name);
    root.problem("horizon '" + spec.name + "' is to have throw at '" + name + "', which is no fault; faults are " +
                 (faults.empty() ? "none" : listed(faults)));
  }
}

}  // namespace

void finish_rules(const YamlValue& root, Project& project) {
  project.rules.column = project.column;
  project.rules.topography = project.naming.topography;
  project.rules.floor = project.naming.floor;
  project.naming.column = project.column;
  for (const SurfaceSpec& spec : project.surfaces) {
    project.rules.surfaces.push_back(spec.rules);
    check_units(root, project, spec);
    check_throw(root, project, spec);
    if (spec.rules.extend != Extend::none && !project.box)
      root.problem("surface '" + spec.name + "' is to be extended to the box, and there is no box");
    if (spec.rules.stop_at.empty()) continue;
    const bool known = std::any_of(project.surfaces.begin(), project.surfaces.end(), [&](const SurfaceSpec& s) {
      return s.name == spec.rules.stop_at && s.name != spec.name;
    });
    if (!known)
      root.problem("surface '" + spec.name + "' is to end at '" + spec.rules.stop_at + "', which is no other surface");
  }
}

}  // namespace geomesh::geomodel
