// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Places on segments where a field has a value, found to rounding for all segments together.
#pragma once

#include <vector>

#include "level_sets/fields/scalar_field.hpp"

namespace geomesh::geomodel {

/// A segment from where the field is below `value` to where it is at or above it. The field less a shift that is linear
/// along the segment is meant.
struct Bracket {
  Vec3 below, above;
  double value_below, value_above;
  double value;
  double shift_below = 0, shift_above = 0;
};

/// A root in each bracket, by the method of Illinois (a secant that halves the value kept too long), then bisection.
/// Where the field jumps across the value, the place of the jump is found. The field is asked for all segments in one
/// call a step.
std::vector<Vec3> find_roots(const ScalarField& field, std::vector<Bracket> brackets);

/// The root in each bracket of the linear function between its ends.
std::vector<Vec3> linear_roots(const std::vector<Bracket>& brackets);

}  // namespace geomesh::geomodel
