// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines the units of components from the heights of horizons in their order of deposition.
#pragma once

#include <vector>

#include "geomesh/geomodel/build_model.hpp"
#include "naming/column.hpp"

namespace geomesh::geomodel {

/// Uses NamingRules::units_at, the order of deposition of the horizons, for components whose faces leave several units
/// possible, or none: the verdicts of kind `incomplete` and `vertical`. If most sampled points agree on one unit, it is
/// chosen. If they leave several, the verdict's range is narrowed to these, and its unit becomes the nearest of them. A
/// component is sampled at its 64 largest tetrahedra. O(tetrahedra) for all components.
void find_units_by_heights(const ConstrainedTetrahedralization& mesh, const NamingRules& rules, const Column& column,
                           std::vector<UnitVerdict>& verdicts);

}  // namespace geomesh::geomodel
