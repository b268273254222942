// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Groups warnings by cause, so that one cause that affects many surfaces is shown once.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace geomesh::geomodel {

/// Returns the cause of a warning, by which warnings are grouped: its text without the leading name, numbers, names
/// that are recognised by their characters (digits, underscores, dots, quotes ...), and everything after the first
/// colon, semicolon or parenthesis. Example: "falls into ... regions".
std::string warning_cause(std::string_view warning);

/// Returns the statement of a warning: its text up to the first colon, semicolon or parenthesis, with names and
/// numbers: "basement falls into 3 regions".
std::string warning_statement(std::string_view warning);

struct WarningGroup {
  std::string cause;
  std::size_t count = 0;
  std::string first;  ///< text of the first warning in the group
};
/// Groups warnings by their cause, in the order in which the causes first occur.
std::vector<WarningGroup> group_warnings(const std::vector<std::string>& warnings);

}  // namespace geomesh::geomodel
