// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads keys that make surfaces from fields (`field`, `value`, `array`, `origin`, `spacing`, `domain`), and the key
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

/// Reads all of these keys except the path in `field`, and reports keys that cannot be combined with a field.
/// `function` is the function that a program gave for the surface; null if none.
void read_level_set(const YamlMap& map, const std::shared_ptr<FieldFunction>& function, SurfaceSpec& spec);

/// Reports keys of a further entry with the same name that belong in its first entry.
void refuse_keys_of_first_entry(const YamlMap& map, const SurfaceSpec& first);

/// Resolves the names in the domains of all fields, and fills SurfaceRules::throw_at, field_parts, holds_above and
/// holds_below from them. Reports unknown names and contradictory domains.
void finish_domains(const YamlValue& root, Project& project);

/// Reads fractures from the file and generates those of the families; mistakes are reported at the value. `box` is that
/// of the project, if it has corners. Throws as the reader of the file.
std::vector<Fracture> read_fractures(const YamlValue& value, const std::filesystem::path& folder,
                                     const std::optional<Box3>& box);

/// Returns the fracture as a surface of the project: a fault that ends where its polygon ends. Throws
/// Error{invalid_input} if the polygon crosses itself.
SurfaceSpec surface_of(const Fracture& fracture);

}  // namespace geomesh::geomodel
