// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A scalar field that a program defines by a function.
#pragma once

#include <memory>
#include <string>

#include "geomesh/geomodel/scalar_field.hpp"
#include "level_sets/fields/scalar_field.hpp"

namespace geomesh::geomodel {

/// A scalar field defined by a function, which is called only inside the box: other places are moved to its border
/// first.
class FunctionField final : public ScalarField {
 public:
  FunctionField(std::shared_ptr<FieldFunction> function, const Box3& box, std::string surface);
  /// Writes the field's value at each place. Throws Error{invalid_input} with the place if the function returns a value
  /// that is not finite, and passes on what the function throws.
  void values(std::span<const Vec3> places, std::span<double> out) const override;

 private:
  std::shared_ptr<FieldFunction> function_;
  Box3 box_;
  std::string surface_;  ///< for messages
};

}  // namespace geomesh::geomodel
