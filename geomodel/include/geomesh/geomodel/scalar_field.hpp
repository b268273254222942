// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Scalar functions of space. A surface of a project can be a level set of such a function (docs/model-building.md,
/// Surfaces that are functions).
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// Scalar function of space. It writes the value at each place of the first span into the second, which has as many
/// entries. It is called from one thread at a time. It may throw; the exception ends the run.
using FieldFunction = std::function<void(std::span<const Vec3>, std::span<double>)>;

/// The domain in which a scalar field is valid: above some surfaces of the project, below others, and in one fault
/// block. Without any of these it is valid everywhere. Above a fault means the side towards which the fault dips.
struct FieldDomain {
  std::vector<std::string> above, below;  ///< names of the horizons and faults above and below which the field is valid
  std::optional<Vec3> block;              ///< a point in the fault block in which the field is valid
  bool is_everywhere() const { return above.empty() && below.empty() && !block; }
};

/// A surface on which a scalar field has one constant value (a level set).
struct LevelSetSpec {
  std::filesystem::path file;  ///< a .vti, .npy or .vtu file with the scalar field; if empty, `function` is used
  std::string file_as_written;
  std::string array;                    ///< name of the array in a VTK file; if empty, the file has only one
  std::optional<Vec3> origin, spacing;  ///< origin and spacing of the grid in a .npy file, whose axes are x, y, z
  /// Scalar function of positions in the project's coordinates, defined in the whole box.
  std::shared_ptr<FieldFunction> function;
  double value = 0;
  FieldDomain domain;
};

}  // namespace geomesh::geomodel
