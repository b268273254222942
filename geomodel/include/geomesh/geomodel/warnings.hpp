// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Warnings by their causes: what is said of many surfaces is one thing to a reader.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace geomesh::geomodel {

/// What a warning says, whatever it says it of: without the name at its beginning, numbers, names that are told by
/// their characters, and all behind the first colon, semicolon or parenthesis. "falls into ... regions".
std::string warning_cause(std::string_view warning);

/// The warning up to its first colon, semicolon or parenthesis, with its name and numbers: "basement falls into 3
/// regions".
std::string warning_statement(std::string_view warning);

struct WarningGroup {
  std::string cause;
  std::size_t count = 0;
  std::string first;  ///< the first warning of its cause
};
/// In the order of their first warnings.
std::vector<WarningGroup> group_warnings(const std::vector<std::string>& warnings);

}  // namespace geomesh::geomodel
