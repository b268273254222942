// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds the points on segments at which a field has a given value, up to rounding, for all segments together.
#pragma once

#include <vector>

#include "level_sets/fields/scalar_field.hpp"

namespace geomesh::geomodel {

/// A segment from a point where the field is below `value` to one where it is not. The field is taken minus a shift
/// that is linear along the segment.
struct Bracket {
  Vec3 below, above;
  double value_below, value_above;
  double value;
  double shift_below = 0, shift_above = 0;
};

/// Finds the root on each segment by the Illinois method (a secant method that halves the value of an end that was kept
/// twice), then by bisection. If the field jumps across the value, the place of the jump is found. Each step evaluates
/// the field on all segments in one call.
std::vector<Vec3> find_roots(const ScalarField& field, std::vector<Bracket> brackets);

/// Returns, for each segment, the root of the linear function between its ends.
std::vector<Vec3> linear_roots(const std::vector<Bracket>& brackets);

}  // namespace geomesh::geomodel
