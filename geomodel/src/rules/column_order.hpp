// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Checks whether horizons lie in the order in which the column lists them.
#pragma once

#include "rules/extend/extend.hpp"

namespace geomesh::geomodel {

/// Warns of each horizon that lies below the next older one of the column nearly everywhere that both are present: the
/// column may be listed from the oldest to the youngest, z may be counted downwards, or two names may be exchanged.
/// Pairs of horizons are skipped if a rule cuts one by the other. Cost: some thousand queries of a map locator per
/// pair.
void warn_of_column_order(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules,
                          const BuildLog& log);

}  // namespace geomesh::geomodel
