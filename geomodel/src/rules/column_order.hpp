// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Whether horizons lie in the order in which the column lists them.
#pragma once

#include "rules/extend/extend.hpp"

namespace geomesh::geomodel {

/// Warns of each horizon that lies below the next older one of the column nearly everywhere that both are: a column
/// from the oldest to the youngest, z counted the other way, or two names exchanged. Pairs of which a rule cuts one by
/// the other are left out. Cost: a few thousand questions to a map locator for each pair.
void warn_of_column_order(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules,
                          const BuildLog& log);

}  // namespace geomesh::geomodel
