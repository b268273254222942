// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Rejects mesh sizes that are absurd for the extent of the model, before they are used.
#pragma once

#include <string>

#include "geomesh/geomodel/refinement.hpp"

namespace geomesh::geomodel {

/// Lengths below this share of a model's diagonal, or of its coordinates, are too close to rounding: doubles resolve
/// them with only about seven digits.
inline constexpr double least_told_apart = 1e-9;

/// Least thickness of a model, and of the scalar field of a surface, as a share of its longest edge. In a thinner
/// model, a single layer of elements as wide as the model is thick has more elements than a whole model usually has.
inline constexpr double least_thickness = 1e-5;

/// Throws Error{usage}, with the key and a suggested value, if a setting of the mesh size is out of range. A size may
/// not be longer than the longest edge of the model's bounding box, nor shorter than a millionth of it. A tolerance
/// lies between a billionth and a tenth of the box's diagonal, and a gradation between a millionth and a million. The
/// box may not be thinner than a hundred-thousandth of its longest edge. Nothing is compared with an empty box.
void require_sizes_in_range(const RefinementSettings& settings, const Box3& bounds);

/// Throws Error{cannot_mesh} if a mesh of the global target size needs more than settings.max_elements elements to fill
/// a volume. Sizes on surfaces can only increase that number. Does nothing if sizes are scaled to reach a requested
/// number of elements.
void require_countable(const RefinementSettings& settings, double volume, const std::string& unit);

/// Estimates how many elements with edges of this size fill a volume.
double elements_of_volume(double volume, double size);

/// Formats a number of elements: "1,234,567", with two digits "1,200,000", and "2.1e+13" for very large numbers.
std::string count_words(double count);
std::string rounded_count(double count);

}  // namespace geomesh::geomodel
