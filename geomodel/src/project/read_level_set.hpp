// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Keys of a surface that is a level set of a field: `field`, `value`, `array`, `origin`, `spacing`.
#pragma once

#include <string_view>
#include <vector>

#include "geomesh/geomodel/project.hpp"
#include "project/yaml_values.hpp"

namespace geomesh::geomodel {

const std::vector<std::string_view>& level_set_keys();

/// Reads all of them but the path in `field`, and reports keys that do not go with a field. `function` is the field
/// that a program gave for the surface; null: none.
void read_level_set(const YamlMap& map, const std::shared_ptr<FieldFunction>& function, SurfaceSpec& spec);

}  // namespace geomesh::geomodel
