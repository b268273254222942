// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Whether the model has the units of its column: the second verdict of a run, beside that of the elements.
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// A unit of the column without a region of its own.
struct MissingUnit {
  std::string name;
  std::string reason;  ///< the reason: "its top base_chalk is not in the model", "it is one region with bunter", ...
};

/// Returns units of the column (unit, horizon, unit, ...) after which no region is named, in its order. Units that
/// share regions (named "a+b") are missing with that reason.
std::vector<MissingUnit> missing_units(const std::vector<std::string>& column, const ModelMesh& mesh);

/// Returns a text such as "2 of 5 units of the column have no region: zechstein (...), bunter (...)"; empty if none is
/// missing.
std::string describe_missing(const std::vector<MissingUnit>& missing, std::size_t n_units);

/// Returns a text such as "all 5 units of the column have regions; 2 warnings about the model".
std::string model_verdict(const std::vector<MissingUnit>& missing, const std::vector<std::string>& column,
                          std::size_t n_warnings);

}  // namespace geomesh::geomodel
