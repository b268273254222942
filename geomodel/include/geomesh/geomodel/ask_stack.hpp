// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// From the project's sizes and volume to what settling the stack and continuing surfaces need to know.
#pragma once

#include "geomesh/geomodel/model_rules.hpp"
#include "geomesh/geomodel/model_volume.hpp"
#include "geomesh/geomodel/refinement.hpp"

namespace geomesh::geomodel {

/// Fills rules.stack: tolerance and outline, and the least size asked of the model, of horizons of the column and
/// inside its units. Leaves it without a tolerance where surfaces are kept exactly, and without an outline where there
/// is no volume: nothing is settled then.
void ask_stack(ModelRules& rules, const RefinementSettings& refinement, const ModelVolume& volume);

/// Fills rules.continuation. A horizon is continued over the size asked there, since triangles of that size cannot tell
/// such a gap, or over a twentieth of the volume's shorter side in the map, whichever is more. A fault that ends inside
/// is more often meant: it is continued over the lesser of the two. `rules.continue_within` takes the place of both.
void ask_continuation(ModelRules& rules, const RefinementSettings& refinement, const ModelVolume& volume);

}  // namespace geomesh::geomodel
