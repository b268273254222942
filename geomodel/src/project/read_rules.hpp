// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The rules of a project file (docs/model-building.md): of one surface, and of the model.
#pragma once

#include "geomesh/geomodel/project.hpp"
#include "project/yaml_values.hpp"

namespace geomesh::geomodel {

/// Keys of rules in an entry of `surfaces`.
const std::vector<std::string_view>& surface_rule_keys();

/// Key cuts: of bodies `all` or `none`; of faults `all` or a list of units.
void read_cuts(const YamlValue& value, SurfaceSpec& spec);

/// The other keys of surface_rule_keys(), of an entry whose name and kind are known.
void read_surface_rules(const YamlMap& map, SurfaceSpec& spec);

/// Key `rules`.
void read_model_rules(const YamlValue& value, Project& project);
/// Key `regions`: own names by seed points.
void read_region_seeds(const YamlValue& value, Project& project);
/// Keys `groups` and `attributes`.
void read_groups(const YamlValue& value, Project& project);
void read_attributes(const YamlValue& value, Project& project);
/// Key `colours`, once units and surfaces are known.
void read_colours(const YamlValue& value, Project& project);

/// What can be checked once everything is read: names in rules, a box where one is needed. Fills project.rules from the
/// rest.
void finish_rules(const YamlValue& root, Project& project);

}  // namespace geomesh::geomodel
