// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Checks whether the model has all units of its stratigraphic column: a verdict of a run beside element quality.
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// A unit of the stratigraphic column without a region of its own.
struct MissingUnit {
  std::string name;
  std::string reason;  ///< why the unit has no region: "its top base_chalk is not in the model", ...
};

/// Returns the units of the stratigraphic column (unit, horizon, unit, ...) for which no region is named, in its order.
/// Units that share a region (named "a+b") count as missing, with this reason.
std::vector<MissingUnit> missing_units(const std::vector<std::string>& column, const ModelMesh& mesh);

/// Returns "2 of 5 units of the column have no region: zechstein (...), bunter (...)"; empty if none is missing.
std::string describe_missing(const std::vector<MissingUnit>& missing, std::size_t n_units);

/// Returns a summary such as "all 5 units of the column have regions; 2 warnings about the model".
std::string model_verdict(const std::vector<MissingUnit>& missing, const std::vector<std::string>& column,
                          std::size_t n_warnings);

}  // namespace geomesh::geomodel
