// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/read_mesh_settings.hpp"

#include <algorithm>
#include <optional>

namespace geomesh::geomodel {

namespace {

void read_positive(const YamlValue& value, double& target) {
  const auto number = value.number();
  if (!number) return;
  if (!(*number > 0)) return value.problem("a number above zero was expected");
  target = *number;
}

/// A size, or {size: S, radius: R}.
AskedSize read_asked(const YamlValue& value) {
  AskedSize asked;
  if (!value.is_map()) {
    read_positive(value, asked.size);
    return asked;
  }
  const YamlMap map(value, {"size", "radius"});
  if (const auto v = map.require("size", "the length that edges should have")) read_positive(*v, asked.size);
  if (const auto v = map.find("radius")) read_positive(*v, asked.radius);
  return asked;
}

/// NAME: size, NAME: {size, radius}. `known` empty: names can only be checked later.
void read_named(const YamlValue& value, const std::vector<std::string_view>& known, const char* what,
                std::map<std::string, AskedSize>& sizes) {
  for (const auto& [name, entry] : named_entries(value, "NAME: size")) {
    sizes[name] = read_asked(entry);
    if (known.empty() || std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::string meant = was_meant(name, known);
    entry.problem("there is no " + std::string(what) + " of this name" +
                  (meant.empty() ? "; known are " + listed(known) : meant));
  }
}

/// `at`: [x, y, z], or the name of an entry of `points`.
bool read_place(const YamlValue& value, const Project& project, Vec3& place) {
  if (value.is_list()) {
    const auto p = value.point();
    if (p) place = *p;
    return p.has_value();
  }
  const auto name = value.text();
  if (!name) return false;
  const auto at =
      std::find_if(project.points.begin(), project.points.end(), [&](const NamedPoint& p) { return p.name == *name; });
  if (at == project.points.end()) {
    value.problem("[x, y, z] or the name of an entry of 'points' was expected");
    return false;
  }
  place = at->point;
  return true;
}

void read_near(const YamlValue& value, const Project& project, NamedSizes& sizes) {
  for (const YamlValue& item : value.items()) {
    const YamlMap map(item, {"at", "size", "radius"});
    if (!map.is_map()) continue;
    PlaceSize near;
    const auto at = map.require("at", "[x, y, z], or the name of an entry of 'points'");
    const bool known = at && read_place(*at, project, near.place);
    if (const auto v = map.require("size", "the length that edges should have")) read_positive(*v, near.asked.size);
    if (const auto v = map.find("radius")) read_positive(*v, near.asked.radius);
    if (known && near.asked.size > 0) sizes.near.push_back(near);
  }
}

std::vector<std::string_view> surface_names(const Project& project) {
  std::vector<std::string_view> names;
  for (const SurfaceSpec& s : project.surfaces) names.push_back(s.name);
  if (project.box) names.insert(names.end(), {"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"});
  return names;
}

void read_background(const YamlValue& value, const Project& project, NamedSizes& sizes) {
  const auto text = value.text();
  if (!text) return;
  sizes.background = (project.file.parent_path() / *text).lexically_normal();
  std::error_code ec;
  if (!std::filesystem::is_regular_file(sizes.background, ec))
    value.problem("there is no file '" + *text + "' (looked for as " + sizes.background.string() + ")");
}

void read_size(const YamlValue& value, const Project& project, RefinementSettings& settings) {
  NamedSizes& sizes = settings.size;
  if (!value.is_map()) return read_positive(value, sizes.base.global);
  const YamlMap map(value, {"global", "units", "surfaces", "curves", "near", "input_edges", "on_surfaces", "curvature",
                            "gap_layers", "gradation", "min", "max", "background"});
  if (const auto v = map.find("global")) read_positive(*v, sizes.base.global);
  if (const auto v = map.find("units")) {
    read_named(*v, {}, "unit", sizes.units);
    for (const auto& [name, asked] : sizes.units)
      if (asked.radius > 0)
        v->problem("a size inside of " + name + " has no radius; give the surfaces about it a size with a radius");
  }
  if (const auto v = map.find("surfaces")) read_named(*v, surface_names(project), "surface", sizes.surfaces);
  if (const auto v = map.find("curves")) read_named(*v, {}, "curve", sizes.curves);
  if (const auto v = map.find("near")) read_near(*v, project, sizes);
  if (const auto v = map.find("input_edges")) sizes.base.from_input_edges = v->boolean().value_or(true);
  if (const auto v = map.find("on_surfaces")) settings.sizes_on_surfaces = v->boolean().value_or(true);
  if (const auto v = map.find("curvature")) read_positive(*v, sizes.base.curvature_angle);
  if (const auto v = map.find("gap_layers")) {
    if (v->scalar() == "none") {
      sizes.base.gap_layers = 0;
    } else {
      read_positive(*v, sizes.base.gap_layers);
    }
  }
  if (const auto v = map.find("gradation")) read_positive(*v, sizes.base.gradation);
  if (const auto v = map.find("min")) read_positive(*v, sizes.base.min_size);
  if (const auto v = map.find("max")) read_positive(*v, sizes.base.max_size);
  if (const auto v = map.find("background")) read_background(*v, project, sizes);
  if (sizes.base.max_size > 0 && sizes.base.min_size > sizes.base.max_size) value.problem("min is greater than max");
}

void read_honour(const YamlMap& mesh, RefinementSettings& settings) {
  const auto honour = mesh.find("honour"), tolerance = mesh.find("tolerance");
  std::optional<std::string> word = "exact";
  if (honour && honour->is_map()) {
    honour->problem(
        "exact or tolerance was expected, found a map; give 'honour: tolerance' and beside it 'tolerance', a length");
    word = std::nullopt;
  } else if (honour) {
    word = honour->choice({"exact", "tolerance"});
  }
  if (word == "tolerance") settings.honour = Honour::tolerance;
  if (tolerance) read_positive(*tolerance, settings.tolerance);
  if (settings.honour == Honour::tolerance && !tolerance)
    honour->problem("how far surfaces may be from the input is missing: give 'tolerance', a length");
  if (tolerance && word == "exact")
    tolerance->problem("has no meaning while surfaces are kept exactly; give 'honour: tolerance' with it");
}

void read_limits(const YamlMap& mesh, RefinementSettings& settings) {
  if (const auto v = mesh.find("max_elements")) {
    double n = 0;
    read_positive(*v, n);
    if (n >= 1) settings.max_elements = static_cast<std::size_t>(std::min(n, 4e9));
  }
  if (const auto v = mesh.find("time_budget")) read_positive(*v, settings.time_budget);
  if (const auto v = mesh.find("cell_arrays")) {
    const std::vector<std::string>& known = known_cell_arrays();
    for (const YamlValue& item : v->items())
      if (const auto name = item.choice({known.begin(), known.end()})) settings.cell_arrays.push_back(*name);
  }
}

}  // namespace

const std::vector<std::string_view>& refinement_keys() {
  static const std::vector<std::string_view> keys{"refine",    "size",         "quality",     "honour",
                                                  "tolerance", "max_elements", "time_budget", "cell_arrays"};
  return keys;
}

void read_refinement(const YamlMap& mesh, Project& project) {
  RefinementSettings& settings = project.mesh.refinement;
  if (const auto v = mesh.find("size")) {
    settings.refine = true;
    read_size(*v, project, settings);
  }
  if (const auto v = mesh.find("quality")) {
    settings.refine = true;
    const auto level = v->choice({"fast", "default", "best"});
    settings.quality = level == "fast"   ? QualityLevel::fast
                       : level == "best" ? QualityLevel::best
                                         : QualityLevel::standard;
  }
  read_honour(mesh, settings);
  settings.refine = settings.refine || settings.honour == Honour::tolerance;
  read_limits(mesh, settings);
  if (const auto v = mesh.find("refine")) {
    const auto word = v->choice({"none", "default"});
    if (word == "none" && settings.refine)
      v->problem("none contradicts 'size', 'quality' or 'honour: tolerance', which ask for refinement");
    settings.refine = settings.refine || word == "default";
  }
  const std::string text = contradiction(settings, project.mesh.options.recover);
  if (!text.empty()) mesh.value().problem(text);
}

}  // namespace geomesh::geomodel
