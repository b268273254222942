// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A field that a program gives as a function.
#pragma once

#include <memory>
#include <string>

#include "geomesh/geomodel/scalar_field.hpp"
#include "level_sets/fields/scalar_field.hpp"

namespace geomesh::geomodel {

/// Asks the function for places in the box alone: places outside are moved to its border first.
class FunctionField final : public ScalarField {
 public:
  FunctionField(std::shared_ptr<FieldFunction> function, const Box3& box, std::string surface);
  /// Throws Error{invalid_input} with the place where the function gives a value that is not finite, and what the
  /// function throws.
  void values(std::span<const Vec3> places, std::span<double> out) const override;

 private:
  std::shared_ptr<FieldFunction> function_;
  Box3 box_;
  std::string surface_;  ///< for messages
};

}  // namespace geomesh::geomodel
