// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Derives from the project's sizes and model volume what settling the stack and continuing surfaces need to know.
#pragma once

#include "geomesh/geomodel/model_rules.hpp"
#include "geomesh/geomodel/model_volume.hpp"
#include "geomesh/geomodel/refinement.hpp"

namespace geomesh::geomodel {

/// Fills rules.stack: the tolerance, the outline of the model, and the smallest target size of the model, on the
/// horizons of the column and inside their units. If surfaces are kept exactly no tolerance is set, and without a
/// volume no outline; in both cases nothing is settled.
void ask_stack(ModelRules& rules, const RefinementSettings& refinement, const ModelVolume& volume);

/// Fills rules.continuation. A horizon is continued across gaps up to the target size there, because triangles of that
/// size cannot resolve a smaller gap, or up to a twentieth of the shorter horizontal side of the volume, whichever is
/// more. A fault that ends inside the model is more often intended, so it is continued over the smaller of the two
/// lengths. `rules.continue_within` replaces both.
void ask_continuation(ModelRules& rules, const RefinementSettings& refinement, const ModelVolume& volume);

}  // namespace geomesh::geomodel
