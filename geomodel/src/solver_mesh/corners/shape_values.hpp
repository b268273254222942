// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Evaluates cell arrays that contain a measure of a tetrahedron's shape.
#pragma once

#include <optional>
#include <string_view>

#include "geomesh/core/quality.hpp"

namespace geomesh::geomodel {

/// Returns the shape measure with the name of a cell array, for a tetrahedron of this shape; nothing if the name is not
/// that of a shape measure.
inline std::optional<double> shape_value(std::string_view name, const TetrahedronShape& s) {
  if (name == "min_dihedral") return s.min_dihedral;
  if (name == "max_dihedral") return s.max_dihedral;
  if (name == "radius_ratio") return s.radius_ratio;
  if (name == "mean_ratio") return s.mean_ratio;
  if (name == "aspect") return s.aspect;
  return std::nullopt;
}

}  // namespace geomesh::geomodel
