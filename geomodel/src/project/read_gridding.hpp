// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads keys that make surfaces from fields (`field`, `value`, `domain`, ...), and the key `fractures` of a project.
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

/// Reads the keys that make a surface from a field, except the path in `field`, and reports keys that cannot be
/// combined with a field. `function` is the function that a calling program gave for the surface; null if none.
void read_level_set(const YamlMap& map, const std::shared_ptr<FieldFunction>& function, SurfaceSpec& spec);

/// Reports keys in a further entry of the same surface that belong in its first entry.
void refuse_keys_of_first_entry(const YamlMap& map, const SurfaceSpec& first);

/// Resolves the names in the domains of all fields, and fills SurfaceRules::throw_at, field_parts, holds_above and
/// holds_below from them. Reports unknown names and contradictory domains.
void finish_domains(const YamlValue& root, Project& project);

/// Reads the fractures in the file that the value names, and generates those of the value's families. Mistakes are
/// reported at the value. `box` is the project's, if it has corners. Throws the same errors as the reader of fracture
/// files.
std::vector<Fracture> read_fractures(const YamlValue& value, const std::filesystem::path& folder,
                                     const std::optional<Box3>& box);

/// Converts a fracture to a surface of the project: a fault that ends where the fracture's polygon ends. Throws
/// Error{invalid_input} if the polygon crosses itself.
SurfaceSpec surface_of(const Fracture& fracture);

}  // namespace geomesh::geomodel
