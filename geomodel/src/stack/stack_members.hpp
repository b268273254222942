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

/// Returns the stack: the topography, the column, and the base of the model. One more horizon is placed above a column
/// that does not name it, with a warning: one that lies above most of the column's first horizon and crosses it only in
/// islands narrower than three elements, which a mesh of that size cannot resolve. Cost: at most 250,000 height queries
/// per horizon that is not named.
Stack find_stack(BuiltSurfaces& built, const ModelRules& rules);

}  // namespace geomesh::geomodel
