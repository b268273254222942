// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Continued horizons up to the walls that bound them.
#pragma once

#include "geomesh/geomodel/model_rules.hpp"

namespace geomesh::geomodel {

/// The horizons with what continues them cut at its walls, for rules that look at heights in the map: beyond a wall a
/// continuation lies over what is given of the next block. Surfaces that were not continued are empty. Points where a
/// wall meets the border of what is given belong to the continuation alone. An arrangement of the walls with the
/// continuations and what touches them.
std::vector<TriangulatedSurface> horizons_up_to_walls(const BuiltSurfaces& built, const ModelRules& rules);

}  // namespace geomesh::geomodel
