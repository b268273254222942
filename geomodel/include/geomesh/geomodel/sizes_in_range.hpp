// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Rejects sizes that are absurd for the model, before they are used.
#pragma once

#include <string>

#include "geomesh/geomodel/refinement.hpp"

namespace geomesh::geomodel {

/// Lengths below this share of a model's diagonal, or of its coordinates, are too close to rounding: doubles resolve
/// them with only about seven digits.
inline constexpr double least_told_apart = 1e-9;

/// Least thickness of a model, and of the field of a surface, as a share of its longest edge. In a thinner model a
/// single layer of elements as wide as the model is thick would have more elements than a whole model usually has.
inline constexpr double least_thickness = 1e-5;

/// Throws Error{usage} that names the key and suggests a value. A size may not be longer than the longest edge of the
/// bounds, nor shorter than a millionth of it. A tolerance lies between a billionth and a tenth of their diagonal. A
/// gradation lies between a millionth and a million. The bounds may not be thinner than a hundred-thousandth of their
/// longest edge. Nothing is checked against empty bounds.
void require_sizes_in_range(const RefinementSettings& settings, const Box3& bounds);

/// Throws Error{cannot_mesh} if elements of the global size fill this volume with more than settings.max_elements,
/// since surfaces can only require more. Does nothing if sizes are to be scaled to a number of elements.
void require_countable(const RefinementSettings& settings, double volume, const std::string& unit);

/// Estimates how many elements with edges of this size fill a volume.
double elements_of_volume(double volume, double size);

/// Formats a number of elements: "1,234,567", with two digits "1,200,000", and "2.1e+13" for very large numbers.
std::string count_words(double count);
std::string rounded_count(double count);

}  // namespace geomesh::geomodel
