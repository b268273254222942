// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Scalar functions of space whose level sets are surfaces of a project (docs/model-building.md, Surfaces that are
/// functions).
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

/// Writes the value at each place into the second span, which has as many entries. It may throw; the exception ends the
/// run. It is called from one thread at a time.
using FieldFunction = std::function<void(std::span<const Vec3>, std::span<double>)>;

/// A domain in which a field is valid: above some surfaces of the project, below others, and in one fault block. An
/// empty domain is all of space. Above a fault means the side towards which the fault dips.
struct FieldDomain {
  std::vector<std::string> above, below;  ///< names of the horizons and faults that bound the domain
  std::optional<Vec3> block;              ///< a point in the fault block
  bool is_everywhere() const { return above.empty() && below.empty() && !block; }
};

/// A surface that is the set of places where a scalar field has one value.
struct LevelSetSpec {
  std::filesystem::path file;  ///< a .vti, .npy or .vtu file; empty: `function` is used
  std::string file_as_written;
  std::string array;                    ///< name of the array in a VTK file; empty: its only one
  std::optional<Vec3> origin, spacing;  ///< origin and spacing of the grid in a .npy file, whose axes are x, y, z
  /// Function of places in the project's coordinates, defined in the whole box.
  std::shared_ptr<FieldFunction> function;
  double value = 0;
  FieldDomain domain;
};

}  // namespace geomesh::geomodel
