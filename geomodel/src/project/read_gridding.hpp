// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Keys that make surfaces of fields (`field`, `value`, `array`, `origin`, `spacing`, `domain`), and the key
/// `fractures` of a project.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "fractures/fracture.hpp"
#include "geomesh/geomodel/project.hpp"
#include "project/read_reading.hpp"
#include "project/yaml_values.hpp"

namespace geomesh::geomodel {

const std::vector<std::string_view>& level_set_keys();

/// Reads all of them but the path in `field`, and reports keys that do not go with a field. `function` is the field
/// that a program gave for the surface; null: none.
void read_level_set(const YamlMap& map, const std::shared_ptr<FieldFunction>& function, SurfaceSpec& spec);

/// Reports the keys of a further entry of one name that belong to its first entry.
void refuse_keys_of_first_entry(const YamlMap& map, const SurfaceSpec& first);

/// Looks up the names in the domains of all fields, and fills SurfaceRules::throw_at, field_parts, holds_above and
/// holds_below from them. Reports names that are unknown and domains that cannot be meant.
void finish_domains(const YamlValue& root, Project& project);

/// Reads the file and draws the families; mistakes are reported at the value. `box`: of the project, where it has
/// corners. Throws as the reader of the file.
std::vector<Fracture> read_fractures(const YamlValue& value, const std::filesystem::path& folder,
                                     const std::optional<Box3>& box);

/// The fracture as a surface of the project: a fault that ends where its polygon ends. Throws Error{invalid_input}
/// where the polygon crosses itself.
SurfaceSpec surface_of(const Fracture& fracture);

}  // namespace geomesh::geomodel
