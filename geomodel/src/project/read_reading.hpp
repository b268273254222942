// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads the keys of a surface entry in a project file that describe its data file and how a surface is made from it:
/// columns, no_data, gridding, below, extrude, object: "*".
#pragma once

#include "geomesh/geomodel/project.hpp"
#include "project/yaml_values.hpp"

namespace geomesh::geomodel {

/// Reads the keys gridding, resample and smooth of a surface entry.
void read_gridding(const YamlMap& map, SurfaceSpec& spec);

/// Reads the keys columns and no_data of an entry, which describe its data file.
void read_reading(const YamlMap& map, ReadOptions& options);

/// Reads the keys below and extrude of a surface entry, and thickness if it belongs to below. `read_file` reads a value
/// as the path of the entry's file.
template <class ReadFile>
void read_made_surface(const YamlMap& map, SurfaceSpec& spec, const ReadFile& read_file);

/// Returns whether YAML reads the text as a number if it is written without quotes.
bool is_number(const std::string& text);

/// Key extrude.
void read_extrude(const YamlValue& value, SurfaceSpec& spec);

/// Returns one entry for each surface and point set in the file of an entry with `object: "*"`. Each is named
/// ENTRY.OBJECT and has its part of the file's contents in place of the file. Throws the same errors as the readers of
/// the file, and Error{invalid_input} if the file contains no object.
std::vector<SurfaceSpec> entries_of_all_objects(const SurfaceSpec& spec);

/// Reports a `below` that does not name a horizon of the project, or that forms a cycle.
void finish_below(const YamlValue& root, const Project& project);

template <class ReadFile>
void read_made_surface(const YamlMap& map, SurfaceSpec& spec, const ReadFile& read_file) {
  if (const auto v = map.find("extrude")) read_extrude(*v, spec);
  const auto below = map.find("below");
  if (!below) return;
  spec.below = below->text().value_or("");
  if (!spec.may_be(SurfaceKind::horizon)) below->problem("only a horizon is given by its thickness below another");
  const auto thickness = map.find("thickness");
  if (!thickness) {
    below->problem("it is allowed with thickness: a length, or the file of a grid or of points with thicknesses");
  } else if (map.find("file")) {
    below->problem("the horizon is made from the one above it and the thickness; leave out 'file'");
  } else if (is_number(thickness->scalar())) {
    spec.below_by = thickness->number();
    if (spec.below_by && *spec.below_by < 0) thickness->problem("a length of zero or more was expected");
  } else {
    read_file(*thickness, spec.file, spec.file_as_written);
  }
}

}  // namespace geomesh::geomodel
