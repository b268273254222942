// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads the keys of a project file that define the coordinate system, units and direction of z (docs/coordinates.md).
#pragma once

#include "geomesh/geomodel/project.hpp"
#include "project/yaml_values.hpp"

namespace geomesh::geomodel {

/// Key `crs`.
void read_crs(const YamlValue& value, CrsSpec& crs);
/// Reads the keys object, crs, unit, z_unit, z and z_datum of an entry in a project file.
void read_source(const YamlMap& map, SourceSpec& source);

}  // namespace geomesh::geomodel
