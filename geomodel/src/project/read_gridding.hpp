// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The keys gridding, resample and smooth of an entry of `surfaces`.
#pragma once

#include "geomesh/geomodel/project.hpp"
#include "project/yaml_values.hpp"

namespace geomesh::geomodel {

void read_gridding(const YamlMap& map, SurfaceSpec& spec);

}  // namespace geomesh::geomodel
