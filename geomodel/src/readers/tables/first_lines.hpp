// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The lines that determine how a table is read: its header, and its first line of data.
#pragma once

#include "readers/tables/table.hpp"

namespace geomesh::geomodel {

/// The first two lines of a table that are neither blank nor comment, as read, and the last comment above them.
struct FirstLines {
  std::string first, second, comment;
};
FirstLines first_lines(LineReader& lines);

std::vector<std::string_view> fields_of_line(std::string_view line, const Separation& separation);

/// Returns the column names in a header line. A unit behind the name of its column is part of it ("Z [m]").
std::vector<std::string> header_names(std::string_view line, const Separation& separation);

std::size_t count_numbers(std::string_view line);

}  // namespace geomesh::geomodel
