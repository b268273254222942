// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Units of components by the horizons as they were laid down.
#pragma once

#include <vector>

#include "geomesh/geomodel/build_model.hpp"
#include "naming/column.hpp"

namespace geomesh::geomodel {

/// Asks the horizons as they were laid down (NamingRules::units_at) about components whose faces leave several units,
/// or none: the verdicts of kind `incomplete` and `vertical`. Where most places leave one unit, it is that. Where they
/// leave several, the verdict's bounds are narrowed to these, and its unit becomes the nearest of them. A component is
/// asked at its 64 largest tetrahedra. O(tetrahedra) for all.
void judge_by_heights(const ConstrainedTetrahedralization& mesh, const NamingRules& rules, const Column& column,
                      std::vector<UnitVerdict>& verdicts);

}  // namespace geomesh::geomodel
