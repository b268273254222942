// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Units of length, as spelled in files and projects.
#pragma once

#include <optional>
#include <string_view>

#include "readers/text/text.hpp"

namespace geomesh::geomodel {

/// Returns how many metres a unit of length has: m, km, ft (international), ftUS (survey) and their spellings; "none"
/// and "unknown" count as metres. Returns nothing if the word is not a unit of length.
std::optional<double> length_unit_in_metres(std::string_view unit);
/// Returns true for units of time (ms, s ...). Surfaces in two-way time cannot be meshed.
bool is_time_unit(std::string_view unit);
/// Returns how many metres a unit of length has. Throws at the current line of `at` if it is unknown or a unit of time.
double length_unit_in_metres(const LineReader& at, std::string_view unit);

}  // namespace geomesh::geomodel
