// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Units of length as files and projects spell them.
#pragma once

#include <optional>
#include <string_view>

#include "readers/text/text.hpp"

namespace geomesh::geomodel {

/// Metres per unit: m, km, ft (international), ftUS (survey) and their spellings; "none" and "unknown" count as metres.
/// Empty where the word is no unit of length.
std::optional<double> length_unit_in_metres(std::string_view unit);
/// True for units of time (ms, s ...): surfaces in two-way time have no place in a mesh.
bool is_time_unit(std::string_view unit);
/// As above; an error at the line of `at` where the unit is one of time or not known.
double length_unit_in_metres(const LineReader& at, std::string_view unit);

}  // namespace geomesh::geomodel
