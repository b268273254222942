// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The lines that determine how a table is read: its header, and its first line of data.
#pragma once

#include "readers/tables/table.hpp"

namespace geomesh::geomodel {

/// The first two lines that are neither blank nor comment, as read, and the last comment above them.
struct FirstLines {
  std::string first, second, comment;
};
FirstLines first_lines(LineReader& lines);

/// Returns the fields of a line of data or of a header, without empty ones at the end.
std::vector<std::string_view> fields_of_line(std::string_view line, const Separation& separation);

/// Returns the names of a header's columns; a unit separated from its name by blanks belongs to it ("Z [m]").
std::vector<std::string> header_names(std::string_view line, const Separation& separation);

/// Returns how many fields of the line are numbers.
std::size_t count_numbers(std::string_view line);

}  // namespace geomesh::geomodel
