// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines which horizons belong to the stack, and which of two neighbours keeps its place.
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/order/column_heights.hpp"

namespace geomesh::geomodel {

/// The stack's horizons, youngest first.
struct Stack {
  std::vector<Index> rows;
  std::vector<std::string> units;  ///< between neighbours
  Keepers keepers;
};

/// Returns the topography, the column, and the base of the model. One more horizon is placed above a column that does
/// not name it: one that lies above most of it and crosses it only in islands narrower than three elements, which a
/// mesh of that size cannot resolve. A warning reports it. Cost: at most 250,000 height queries per horizon that is not
/// named.
Stack find_stack(BuiltSurfaces& built, const ModelRules& rules);

}  // namespace geomesh::geomodel
