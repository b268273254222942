// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Which horizons the stack has, and which of two neighbours keeps its place.
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

/// The topography, the column, the bottom of the model. One horizon more stands over the column that does not name it:
/// one that lies over most of it and crosses it in islands of less than three elements. No mesh of that size shows
/// these. A warning tells of it. Cost: of looking for heights at most 250,000 times a horizon that is not named.
Stack find_stack(BuiltSurfaces& built, const ModelRules& rules);

}  // namespace geomesh::geomodel
