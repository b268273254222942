// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines which horizons belong to the stack, and which of two neighbours keeps its height.
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/order/column_heights.hpp"

namespace geomesh::geomodel {

/// The horizons of a stack, youngest first.
struct Stack {
  std::vector<Index> rows;
  std::vector<std::string> units;  ///< between neighbours
  Keepers keepers;
};

/// Returns the topography, the column, and the base of the model.
Stack find_stack(const BuiltSurfaces& built, const ModelRules& rules);

}  // namespace geomesh::geomodel
