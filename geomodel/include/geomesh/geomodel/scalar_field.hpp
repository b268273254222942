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

/// A domain tells where a field holds: above some surfaces of the project, below others, and in one fault block. An
/// empty one is everywhere. Above a fault is the side to which the fault dips.
struct FieldDomain {
  std::vector<std::string> above, below;  ///< names of horizons and faults
  std::optional<Vec3> block;              ///< a place in the fault block
  bool is_everywhere() const { return above.empty() && below.empty() && !block; }
};

/// A surface that is the set of places where a scalar field has one value.
struct LevelSetSpec {
  std::filesystem::path file;  ///< .vti, .npy or .vtu; empty: `function`
  std::string file_as_written;
  std::string array;                        ///< of a VTK file; empty: the only one
  std::optional<Vec3> origin, spacing;      ///< of the grid in a .npy file, whose axes are x, y, z
  std::shared_ptr<FieldFunction> function;  ///< in the project's coordinates; its domain is the box
  double value = 0;
  FieldDomain domain;
};

}  // namespace geomesh::geomodel
