// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Handles layers of the column that are thinner than the project requires.
#pragma once

#include "geomesh/geomodel/model_rules.hpp"

namespace geomesh::geomodel {

/// Applies ModelRules::min_thickness to consecutive horizons of the column, as far as both lie over the same place in
/// the map. With `collapse`, horizons that come too close to each other somewhere get one common triangulation of the
/// map with the edges of all. From the oldest up, each point closer than min_thickness to the next older horizon takes
/// that horizon's height: both coincide there, and the layer pinches out. Horizons that overhang or are given block by
/// block are not changed, with a warning. With `error`, throws Error{invalid_input} if a layer is too thin.
void apply_min_thickness(BuiltSurfaces& built, const ModelRules& rules);

}  // namespace geomesh::geomodel
