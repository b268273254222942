// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The lines from which a table is understood: its header, and its first line of data.
#pragma once

#include "readers/tables/table.hpp"

namespace geomesh::geomodel {

/// The first two lines that are neither blank nor comment, as they were read, and the last comment above them.
struct FirstLines {
  std::string first, second, comment;
};
FirstLines first_lines(LineReader& lines);

/// Fields of a line of data or of a header, without empty ones at the end.
std::vector<std::string_view> fields_of_line(std::string_view line, const Separation& separation);

/// The names of a header's columns; a unit that blanks part from its name belongs to it ("Z [m]").
std::vector<std::string> header_names(std::string_view line, const Separation& separation);

/// How many fields of the line are numbers.
std::size_t count_numbers(std::string_view line);

}  // namespace geomesh::geomodel
