// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads the geological rules of a project file (docs/model-building.md), for single surfaces and for the model.
#pragma once

#include "geomesh/geomodel/project.hpp"
#include "project/yaml_values.hpp"

namespace geomesh::geomodel {

/// Names of the keys for rules in an entry of `surfaces`.
const std::vector<std::string_view>& surface_rule_keys();

/// Reads the key cuts: `all` or `none` for bodies; `all` or a list of units for faults.
void read_cuts(const YamlValue& value, SurfaceSpec& spec);

/// Reads all keys of surface_rule_keys() except `cuts`, for an entry whose name and kind are known.
void read_surface_rules(const YamlMap& map, SurfaceSpec& spec);

/// Key `rules`.
void read_model_rules(const YamlValue& value, Project& project);
/// Reads the key `regions`: names assigned by seed points.
void read_region_seeds(const YamlValue& value, Project& project);
void read_groups(const YamlValue& value, Project& project);
void read_attributes(const YamlValue& value, Project& project);
/// Reads the key `colours`, after units and surfaces are known.
void read_colours(const YamlValue& value, Project& project);

/// Checks rules that refer to other parts of the project: names in rules, and the box if a rule needs it. Fills
/// project.rules from the rest of the project.
void finish_rules(const YamlValue& root, Project& project);

}  // namespace geomesh::geomodel
