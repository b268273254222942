// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Layers of the column that are thinner than the project wants them.
#pragma once

#include "geomesh/geomodel/model_rules.hpp"

namespace geomesh::geomodel {

/// Applies ModelRules::min_thickness to consecutive horizons of the column, as far as both lie over the same place in
/// the map.
///
/// `collapse`: horizons that come too near each other somewhere get one common triangulation of the map, with all
/// edges of all of them. From the oldest up, each point that is nearer than min_thickness to the next older horizon
/// takes its height: there both coincide, and the layer pinches out. Horizons that overhang or are given block by block
/// are left as they are, with a warning. Throws Error{invalid_input} for `error` where a layer is too thin.
void apply_min_thickness(BuiltSurfaces& built, const ModelRules& rules);

}  // namespace geomesh::geomodel
