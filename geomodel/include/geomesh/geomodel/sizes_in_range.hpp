// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Sizes that cannot be meant: refused before anything is read into them.
#pragma once

#include <string>

#include "geomesh/geomodel/refinement.hpp"

namespace geomesh::geomodel {

/// Lengths below this share of a model's diagonal, or of its coordinates, are too near to their rounding: doubles tell
/// them apart to some seven digits.
inline constexpr double least_told_apart = 1e-9;

/// A model, and the field of a surface, is at least this share of its longest edge thick. In a thinner one, a single
/// row of elements as long as it is thick has more of them than a whole model usually has.
inline constexpr double least_thickness = 1e-5;

/// Throws Error{usage} that names the key and suggests a value. A size may not be longer than the longest edge of the
/// bounds, nor shorter than a millionth of it. A tolerance lies between a billionth and a tenth of their diagonal. A
/// gradation lies between a millionth and a million. The bounds may not be thinner than a hundred-thousandth of their
/// longest edge. Nothing is checked against empty bounds.
void require_sizes_in_range(const RefinementSettings& settings, const Box3& bounds);

/// Throws Error{cannot_mesh} where edges of the size of the whole model fill this volume with more elements than
/// settings.max_elements: surfaces can only ask for more. Unless all sizes are to be scaled to a number of elements.
void require_countable(const RefinementSettings& settings, double volume, const std::string& unit);

/// About how many elements of even edges fill a volume.
double elements_of_volume(double volume, double size);

/// A number of elements as words: "1,234,567", with two digits "1,200,000", and "2.1e+13" beyond what anybody counts.
std::string count_words(double count);
std::string rounded_count(double count);

}  // namespace geomesh::geomodel
