// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/read_mesh_settings.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

namespace geomesh::geomodel {

namespace {

void read_positive(const YamlValue& value, double& target) {
  const auto number = value.number();
  if (!number) return;
  if (!(*number > 0)) return value.problem("a number above zero was expected");
  target = *number;
}

/// Reads a target size S, or a map {size: S, radius: R}.
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

/// Reads target sizes by name: NAME: size, or NAME: {size, radius}. If `known` is empty, names are checked later.
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

/// Reads the position of a target size from `at`: [x, y, z], or the name of an entry of `points`.
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

/// The value `at: points`, which stands for every entry of `points`.
constexpr std::string_view all_points = "points";

void read_near(const YamlValue& value, const Project& project, NamedSizes& sizes) {
  for (const YamlValue& item : value.items()) {
    const YamlMap map(item, {"at", "size", "radius"});
    if (!map.is_map()) continue;
    PlaceSize near;
    const auto at = map.require("at", "[x, y, z], or the name of an entry of 'points'");
    const bool known = at && at->scalar() != all_points && read_place(*at, project, near.place);
    if (const auto v = map.require("size", "the length that edges should have")) read_positive(*v, near.asked.size);
    if (const auto v = map.find("radius")) read_positive(*v, near.asked.radius);
    if (known && near.asked.size > 0) sizes.near.push_back(near);
    for (const NamedPoint& p : project.points)
      if (at && at->scalar() == all_points && near.asked.size > 0) sizes.near.push_back({p.point, near.asked});
  }
}

std::vector<std::string_view> surface_names(const Project& project) {
  std::vector<std::string_view> names{"horizons", "faults", "bodies"};
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

void read_frequency(const YamlValue& value, double& frequency) {
  const std::string text = value.scalar();
  const std::size_t end = text.find_last_not_of(" Hhz");
  double number = 0;
  const char* const last = text.data() + (end == std::string::npos ? 0 : end + 1);
  const auto [at, status] = std::from_chars(text.data(), last, number);
  if (status != std::errc() || at != last || !(number > 0)) return value.problem("a frequency was expected, as 5 Hz");
  frequency = number;
}

/// Reads a table of target sizes by depth, [[depth, size], ...], with ascending depths.
void read_by_depth(const YamlValue& value, NamedSizes& sizes) {
  for (const YamlValue& row : value.items()) {
    const std::vector<YamlValue> pair = row.items();
    const auto depth = pair.size() == 2 ? pair[0].number() : std::nullopt;
    NamedSizes::DepthSize entry{depth.value_or(0), 0};
    if (pair.size() == 2) read_positive(pair[1], entry.size);
    if (!depth || !(entry.size > 0)) return row.problem("[depth, size] was expected");
    if (!sizes.by_depth.empty() && !(entry.depth > sizes.by_depth.back().depth))
      return row.problem("depths must rise from row to row");
    sizes.by_depth.push_back(entry);
  }
}

/// Default number of elements across the gap between two surfaces if surfaces have a tolerance: edges are at most two
/// and a half times as long as the gap is wide.
constexpr double default_gap_layers = 0.4;

const std::vector<std::string_view>& size_keys() {
  static const std::vector<std::string_view> keys{"global",     "units",       "surfaces",    "curves",
                                                  "near",       "input_edges", "on_surfaces", "curvature",
                                                  "gap_layers", "gradation",   "min",         "max",
                                                  "background", "layers",      "frequency",   "points_per_wavelength",
                                                  "by_depth"};
  return keys;
}

/// Whether the project gives those keys of `size` whose default depends on whether surfaces are kept exactly.
struct SizeKeysGiven {
  bool input_edges = false, gap_layers = false, gradation = false;
};

SizeKeysGiven read_size(const YamlValue& value, const Project& project, RefinementSettings& settings) {
  NamedSizes& sizes = settings.size;
  if (!value.is_map()) {
    read_positive(value, sizes.base.global);
    return {};
  }
  const YamlMap map(value, size_keys());
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
  if (const auto v = map.find("layers"))
    for (const auto& [name, entry] : named_entries(*v, "UNIT: number of elements"))
      read_positive(entry, sizes.layers[name]);
  if (const auto v = map.find("frequency")) read_frequency(*v, sizes.frequency);
  if (const auto v = map.find("points_per_wavelength")) read_positive(*v, sizes.points_per_wavelength);
  if (const auto v = map.find("by_depth")) read_by_depth(*v, sizes);
  if (sizes.base.max_size > 0 && sizes.base.min_size > sizes.base.max_size) value.problem("min is greater than max");
  return {map.find("input_edges").has_value(), map.find("gap_layers").has_value(), map.find("gradation").has_value()};
}

/// Reads the key `honour` into the settings. Returns its value; empty if it is not given.
std::optional<std::string> read_honour(const YamlMap& mesh, RefinementSettings& settings,
                                       std::vector<std::string>& notes) {
  const auto honour = mesh.find("honour"), tolerance = find_renamed(mesh, "surfaces_within", "tolerance", notes);
  std::optional<std::string> word;
  if (honour && honour->is_map()) {
    honour->problem(
        "exact or tolerance was expected, found a map; give 'honour: tolerance' and beside it 'surfaces_within', a "
        "length");
  } else if (honour) {
    word = honour->choice({"exact", "tolerance"});
  }
  if (tolerance && word == "exact")
    tolerance->problem("has no meaning while surfaces are kept exactly; give 'honour: tolerance' with it");
  if (double length = 0; tolerance && (read_positive(*tolerance, length), length > 0))
    settings.tolerance = ToleranceLedger::of_length(length);
  if (tolerance && !honour) word = "tolerance";
  if (word == "tolerance") settings.honour = Honour::tolerance;
  return word;
}

void read_limits(const YamlMap& mesh, RefinementSettings& settings) {
  if (const auto v = mesh.find("max_elements")) {
    double n = 0;
    read_positive(*v, n);
    if (n >= 1) settings.max_elements = static_cast<std::size_t>(std::min(n, 4e9));
  }
  if (const auto v = mesh.find("target_elements")) read_positive(*v, settings.target_elements);
  if (const auto v = mesh.find("time_budget")) read_positive(*v, settings.time_budget);
  if (const auto v = mesh.find("cell_arrays")) {
    const std::vector<std::string>& known = known_cell_arrays();
    for (const YamlValue& item : v->items())
      if (const auto name = item.choice({known.begin(), known.end()})) settings.cell_arrays.push_back(*name);
  }
}

}  // namespace

const std::vector<std::string_view>& refinement_keys() {
  static const std::vector<std::string_view> keys{
      "refine",    "size",         "quality",     "quality_measure", "honour",         "surfaces_within",
      "tolerance", "max_elements", "time_budget", "cell_arrays",     "target_elements"};
  return keys;
}

namespace {

/// Returns whether the project requests something incompatible with moving surfaces within a tolerance.
bool excludes_default(const Project& project) {
  const RecoverOptions& recover = project.mesh.options.recover;
  return recover.mode == MeshMode::conforming || recover.preserve_boundary || project.crs.z_scale != 1;
}

/// Lets the mesher remesh surfaces according to the target sizes, without regard to the edges of the input.
void follow_sizes(const SizeKeysGiven& given, RefinementSettings& settings) {
  SizeOptions& base = settings.size.base;
  settings.refine = true;
  settings.honour = Honour::tolerance;
  if (!(settings.tolerance.left() > 0)) settings.tolerance = ToleranceLedger::of_sizes(default_tolerance_share);
  if (!given.input_edges) base.from_input_edges = false;
  settings.gaps_by_default = !given.gap_layers;
  settings.gradation_by_default = !given.gradation;
  if (settings.gaps_by_default) base.gap_layers = default_gap_layers;
  settings.derive_size = !(base.global > 0) && settings.size.background.empty() && settings.size.by_depth.empty();
}

}  // namespace

void default_refinement(Project& project) {
  if (!excludes_default(project)) follow_sizes({}, project.mesh.refinement);
}

void read_refinement(const YamlMap& mesh, Project& project) {
  RefinementSettings& settings = project.mesh.refinement;
  const auto size = mesh.find("size"), quality = mesh.find("quality"), refine = mesh.find("refine");
  const SizeKeysGiven given = size ? read_size(*size, project, settings) : SizeKeysGiven{};
  if (quality) {
    const auto level = quality->choice({"fast", "default", "best"});
    settings.quality = level == "fast"   ? QualityLevel::fast
                       : level == "best" ? QualityLevel::best
                                         : QualityLevel::standard;
  }
  const auto measure = mesh.find("quality_measure");
  if (measure) {
    const auto name = measure->choice({quality_measure_names.begin(), quality_measure_names.end()});
    settings.quality_measure = quality_measure_of(name.value_or("")).value_or(QualityMeasure::dihedral);
  }
  const auto honour = read_honour(mesh, settings, project.notes);
  read_limits(mesh, settings);
  const auto word = refine ? refine->choice({"none", "default"}) : std::nullopt;
  const bool is_asked = size || quality || measure || honour || word == "default" || settings.target_elements > 0;
  if (word == "none" && (size || quality || measure || honour == "tolerance"))
    refine->problem(
        "none contradicts 'size', 'quality', 'quality_measure' or 'honour: tolerance', which request refinement");
  if (word != "none" && is_asked) settings.refine = true;
  const bool is_kept = honour == "exact" || !settings.sizes_on_surfaces || excludes_default(project);
  if (honour == "tolerance" || (word != "none" && !is_kept)) follow_sizes(given, settings);
  const std::string text = contradiction(settings, project.mesh.options.recover);
  if (!text.empty()) mesh.value().problem(text);
}

}  // namespace geomesh::geomodel
