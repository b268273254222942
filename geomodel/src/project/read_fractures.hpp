// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Key `fractures` of a project.
#pragma once

#include <filesystem>
#include <vector>

#include "fractures/fracture.hpp"
#include "geomesh/geomodel/project.hpp"
#include "project/yaml_values.hpp"

namespace geomesh::geomodel {

/// Reads the file and draws the families; mistakes are reported at the value. `box`: of the project, where it has
/// corners. Throws as the reader of the file.
std::vector<Fracture> read_fractures(const YamlValue& value, const std::filesystem::path& folder,
                                     const std::optional<Box3>& box);

/// The fracture as a surface of the project: a fault that ends where its polygon ends. Throws Error{invalid_input}
/// where the polygon crosses itself.
SurfaceSpec surface_of(const Fracture& fracture);

}  // namespace geomesh::geomodel
