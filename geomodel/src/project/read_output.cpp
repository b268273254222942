// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/read_output.hpp"

#include <algorithm>
#include <cmath>

#include "formats/fractures_alone.hpp"
#include "geomesh/geomodel/formats.hpp"
#include "solver_mesh/corners/solver_splits.hpp"

namespace geomesh::geomodel {

namespace {

/// Returns whether a format chosen earlier writes a file with the same name, so that the later one is refused.
bool is_taken(const std::vector<std::string>& chosen, const std::string& name) {
  const Format* const format = format_of_name(name);
  return format && std::any_of(chosen.begin(), chosen.end(), [&](const std::string& other) {
           const Format* const o = format_of_name(other);
           return o && o->extensions.front() == format->extensions.front();
         });
}

void read_formats(const YamlValue& value, std::vector<std::string>& formats) {
  const std::vector<std::string> known = known_formats();
  const std::vector<std::string_view> words(known.begin(), known.end());
  formats.clear();
  for (const YamlValue& item : value.items()) {
    const auto format = item.choice(words);
    if (!format || std::find(formats.begin(), formats.end(), *format) != formats.end()) continue;
    if (is_taken(formats, *format)) {
      item.problem("another format of the list has the same file name; one of them was expected");
    } else {
      formats.push_back(*format);
    }
  }
  if (value.is_list() && formats.empty() && value.items().empty()) value.problem("the list of formats is empty");
}

void read_split(const YamlValue& value, const Project& project, WriteOptions& options) {
  std::vector<std::string_view> names;
  for (const SurfaceSpec& surface : project.surfaces) names.push_back(surface.name);
  options.split.clear();
  for (const YamlValue& item : value.items())
    if (const auto name = item.choice(names)) options.split.push_back(*name);
}

void read_fault_zones(const YamlValue& value, const Project& project, WriteOptions& options) {
  for (const auto& [name, entry] : named_entries(value, "a map of faults: {F1: {thickness: 20, layers: 2}}")) {
    FaultZone zone{name};
    const auto is_named = [&](const SurfaceSpec& s) { return s.name == zone.fault; };
    if (std::none_of(project.surfaces.begin(), project.surfaces.end(), is_named))
      entry.problem("there is no surface " + name);
    if (std::find(options.split.begin(), options.split.end(), name) != options.split.end())
      entry.problem("this surface is to be split too; one of the two was expected");
    const YamlMap map(entry, {"thickness", "layers"});
    if (const auto v = map.require("thickness", "the distance of the two walls"))
      if (const auto length = v->number()) {
        if (!(*length > 0)) v->problem("a length above 0 was expected");
        zone.thickness = *length;
      }
    if (const auto v = map.find("layers"))
      if (const auto n = v->number()) {
        if (*n < 1 || *n > most_zone_layers || *n != std::floor(*n))
          v->problem("a whole number from 1 to " + std::to_string(most_zone_layers) + " was expected");
        zone.layers = static_cast<unsigned>(*n);
      }
    options.fault_zones.push_back(std::move(zone));
  }
}

void read_partitions(const YamlValue& value, WriteOptions& options) {
  const auto n = value.number();
  if (!n) return;
  if (*n < 1 || *n > most_partitions || *n != std::floor(*n))
    return value.problem("a whole number from 1 to " + std::to_string(most_partitions) + " was expected");
  options.partitions = static_cast<unsigned>(*n);
  if (options.partitions > 1 && (options.cohesive || options.single_grid))
    value.problem("cohesive and single_grid are not written in parts");
}

void read_options(const YamlMap& map, const Project& project, WriteOptions& options) {
  if (const auto v = map.find("groups"))
    if (const auto word = v->choice({"whole", "pieces", "both"}))
      options.groups = *word == "whole"    ? GroupChoice::whole
                       : *word == "pieces" ? GroupChoice::pieces
                                           : GroupChoice::both;
  if (const auto v = map.find("inner_faces")) options.inner_faces = v->boolean().value_or(true);
  if (const auto v = map.find("curves")) options.curves = v->boolean().value_or(true);
  if (const auto v = map.find("order"))
    if (const auto order = v->number()) {
      if (*order != 1 && *order != 2) v->problem("1 or 2 was expected");
      options.order = *order == 2 ? ElementOrder::second : ElementOrder::first;
    }
  if (const auto v = map.find("region_array"))
    if (const auto name = v->choice({"region", "MaterialIDs", "attribute"})) options.region_array = *name;
  if (const auto v = map.find("single_grid")) options.single_grid = v->boolean().value_or(false);
  if (const auto v = map.find("node_arrays")) options.node_arrays = v->boolean().value_or(false);
  if (const auto v = map.find("compression"))
    if (const auto word = v->choice({"none", "fast", "small"}))
      options.compression = *word == "none"   ? Compression::none
                            : *word == "fast" ? Compression::fast
                                              : Compression::small;
  if (const auto v = map.find("split")) read_split(*v, project, options);
  if (const auto v = map.find("fault_zone")) read_fault_zones(*v, project, options);
  if (const auto v = map.find("cohesive")) {
    options.cohesive = v->boolean().value_or(false);
    if (options.cohesive && options.split.empty())
      v->problem("cohesive prisms need faults to split: split was expected");
    if (options.cohesive && options.order == ElementOrder::second) v->problem("cohesive prisms are of first order");
  }
  if (const auto v = map.find("partitions")) read_partitions(*v, options);
  if (const auto v = map.find("starter")) options.starter = v->boolean().value_or(false);
  if (const auto v = map.find("fractures_only")) {
    options.fractures_only = v->boolean().value_or(false);
    const auto is_fault = [](const SurfaceSpec& s) { return s.kind == SurfaceKind::fault; };
    if (options.fractures_only && std::none_of(project.surfaces.begin(), project.surfaces.end(), is_fault))
      v->problem("the model has neither fractures nor faults; leave it out");
  }
}

/// Returns whether VTU files already have an array of this name that is not a field of the project.
bool is_array_of_ours(const std::string& name) {
  const std::vector<std::string>& cells = known_cell_arrays();
  static const std::vector<std::string> others{"region",         "MaterialIDs",  "attribute",    "kind",
                                               "input_vertex",   "patch",        "before_zones", "GlobalCellIds",
                                               "GlobalPointIds", "vtkGhostType", "partition"};
  return std::find(cells.begin(), cells.end(), name) != cells.end() ||
         std::find(others.begin(), others.end(), name) != others.end();
}

void read_fields(const YamlValue& value, const std::filesystem::path& folder, WriteOptions& options) {
  for (const auto& [name, entry] : named_entries(value, "a map of fields: {porosity: {file: poro.tif}}")) {
    FieldSpec field{name, {}, FieldSpec::Place::cells, ""};
    const YamlMap map(entry, {"file", "on", "unit"});
    if (const auto v = map.require("file", "the grid or points"))
      if (const auto text = v->text()) {
        field.file = (folder / *text).lexically_normal();
        if (!std::filesystem::is_regular_file(field.file)) v->problem("there is no file " + field.file.string());
      }
    if (const auto v = map.find("on"))
      if (const auto word = v->choice({"cells", "points"}))
        field.place = *word == "cells" ? FieldSpec::Place::cells : FieldSpec::Place::points;
    if (const auto v = map.find("unit")) field.unit = v->text().value_or("");
    if (is_array_of_ours(name)) entry.problem("geomesh writes an array of this name itself; another was expected");
    options.fields.push_back(std::move(field));
  }
}

/// Reports before meshing what the chosen file formats cannot represent.
void check_formats(const YamlValue& value, const OutputSpec& output) {
  for (const std::string& name : output.formats) {
    const Format* const format = format_of_name(name);
    if (!format) continue;
    if (output.options.order == ElementOrder::second && !format->holds.second_order)
      value.problem("the format " + name + " holds no elements of second order here; order: 1 was expected");
    if (output.options.cohesive && !format->holds.prisms)
      value.problem("the format " + name + " holds no cohesive prisms here; cohesive: false was expected");
    if (!output.options.split.empty() && solver_splits_faults(name))
      value.problem("the format " + name +
                    " holds no split faults, because its solver splits them; no split was expected");
    if (output.options.partitions > 1 && !format->holds.partitions)
      value.problem("the format " + name + " is not written in parts here; partitions: 1 was expected");
    if (!output.options.fractures_only) continue;
    if (const std::string reason = against_fractures_alone(*format, output.options); !reason.empty())
      value.problem(reason);
  }
}

}  // namespace

void read_output(const YamlValue& value, const std::filesystem::path& folder, Project& project) {
  const YamlMap map(value, {"directory", "formats", "origin", "groups", "inner_faces", "curves", "order",
                            "region_array", "single_grid", "node_arrays", "compression", "split", "fault_zone",
                            "cohesive", "partitions", "starter", "fields", "fractures_only"});
  OutputSpec& output = project.output;
  if (const auto v = map.find("directory")) {
    if (const auto text = v->text()) output.directory = (folder / *text).lexically_normal();
  }
  if (const auto v = map.find("formats")) read_formats(*v, output.formats);
  if (const auto v = map.find("origin"))
    if (const auto origin = v->point()) output.origin = *origin;
  read_options(map, project, output.options);
  if (const auto v = map.find("fields")) read_fields(*v, folder, output.options);
  check_formats(value, output);
}

}  // namespace geomesh::geomodel
