// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Derives from the sizes and the volume of a project the settings for ordering horizons in the map (the settled stack)
/// and for continuing surfaces.
#pragma once

#include "geomesh/geomodel/model_rules.hpp"
#include "geomesh/geomodel/model_volume.hpp"
#include "geomesh/geomodel/refinement.hpp"

namespace geomesh::geomodel {

/// Fills rules.stack: the tolerance, the outline of the model on the map, and the smallest target size on horizons and
/// inside units. No tolerance is set if surfaces are kept exactly, and no outline if there is no volume; in both cases
/// horizons are not put in order.
void ask_stack(ModelRules& rules, const RefinementSettings& refinement, const ModelVolume& volume);

/// Fills rules.continuation. A horizon is continued across gaps up to the target size there, because triangles of that
/// size cannot resolve a smaller gap, or up to a twentieth of the shorter horizontal side of the volume, whichever is
/// more. A fault that ends inside the model is more often intended, so it is continued over the smaller of the two
/// lengths. `rules.continue_within` replaces both.
void ask_continuation(ModelRules& rules, const RefinementSettings& refinement, const ModelVolume& volume);

}  // namespace geomesh::geomodel
