// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/read_reading.hpp"

#include <algorithm>
#include <set>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/readers.hpp"
#include "geomesh/geomodel/sticks.hpp"
#include "readers/objects_of_file.hpp"

namespace geomesh::geomodel {
namespace {

/// Reads the key `columns`: a list of the meaning of each column ("-": none), or a map with the column of each meaning.
void read_columns(const YamlValue& value, ReadOptions& options) {
  if (value.is_list()) {
    const std::vector<YamlValue> items = value.items();
    for (std::size_t i = 0; i < items.size(); ++i) {
      const auto meaning = items[i].text();
      if (meaning && *meaning != "-") options.columns.push_back({*meaning, std::to_string(i + 1)});
    }
  } else if (value.is_map()) {
    for (const auto& [meaning, column] : named_entries(value, "MEANING: COLUMN"))
      if (const auto text = column.text()) options.columns.push_back({meaning, *text});
  } else {
    return value.problem(
        "the meanings of the columns were expected, in their order ([id, x, y, z]) or by name or number ({x: "
        "Rechtswert, y: 3, z: 4})");
  }
  if (options.columns.empty()) value.problem("it names no column");
}

}  // namespace

bool is_number(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789.+-eE") == std::string::npos;
}

void read_reading(const YamlMap& map, ReadOptions& options) {
  if (const auto v = map.find("columns")) read_columns(*v, options);
  if (const auto v = map.find("no_data")) {
    if (v->scalar() == "none") {
      options.keep_all_heights = true;
    } else {
      options.no_data = v->number();
    }
  }
}

void read_extrude(const YamlValue& value, SurfaceSpec& spec) {
  const YamlMap map(value, {"along", "from", "to"});
  if (!map.is_map()) return;
  if (const auto v = map.require("along", "x or y")) {
    const auto axis = v->choice({"x", "y"});
    spec.extrude.axis = axis == "y" ? 1 : 0;
  }
  const auto from = map.require("from", "where the surface begins along this axis");
  const auto to = map.require("to", "where it ends along this axis");
  if (!from || !to) return;
  spec.extrude.from = from->number().value_or(0);
  spec.extrude.to = to->number().value_or(1);
  if (!(spec.extrude.from < spec.extrude.to)) value.problem("'to' must be greater than 'from'");
}

std::vector<SurfaceSpec> entries_of_all_objects(const SurfaceSpec& spec) {
  const FileContents contents = spec.given ? *spec.given : read_surface_file(spec.file, spec.source.reading);
  std::vector<SurfaceSpec> entries;
  std::set<std::string> taken;
  for (FileContents& object : objects_of_file(contents)) {
    SurfaceSpec entry = spec;
    std::string name = !object.surfaces.empty()     ? object.surfaces.front().name
                       : !object.point_sets.empty() ? object.point_sets.front().name
                                                    : name_without_part(object.polylines.front().name);
    for (char& c : name)
      if (static_cast<unsigned char>(c) < 0x20 || c == '"' || c == '\'' || c == ',' || c == '/' || c == '\\') c = '_';
    std::string unique = name;
    for (int n = 2; !taken.insert(unique).second; ++n) unique = name + "_" + std::to_string(n);
    entry.name = spec.name + "." + unique;
    entry.source.object.clear();
    entry.given = std::make_shared<const FileContents>(std::move(object));
    entries.push_back(std::move(entry));
  }
  if (entries.empty())
    throw Error(ErrorKind::invalid_input,
                "surface " + spec.name + ": " + spec.file_as_written + " (" + contents.format +
                    ") holds no surface, no points and no lines, of which object: \"*\" takes all");
  return entries;
}

void finish_below(const YamlValue& root, const Project& project) {
  const auto horizon = [&](const std::string& name) {
    return std::find_if(project.surfaces.begin(), project.surfaces.end(),
                        [&](const SurfaceSpec& s) { return s.name == name && s.may_be(SurfaceKind::horizon); });
  };
  for (const SurfaceSpec& spec : project.surfaces) {
    std::set<std::string> passed{spec.name};
    for (std::string above = spec.below; !above.empty();) {
      const auto found = horizon(above);
      if (found == project.surfaces.end()) {
        root.problem("horizon '" + spec.name + "' is to lie below '" + above + "', and no horizon has this name");
        break;
      }
      if (!passed.insert(above).second) {
        root.problem("horizon '" + spec.name + "' is to lie below '" + spec.below +
                     "', which itself is to lie below it");
        break;
      }
      above = found->below;
    }
  }
}

}  // namespace geomesh::geomodel
