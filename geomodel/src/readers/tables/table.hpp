// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Tables of points in text: how their fields are separated, what their columns mean, and how they are converted.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geomesh/geomodel/surface.hpp"
#include "readers/grids/grid.hpp"
#include "readers/text/text.hpp"

namespace geomesh::geomodel {

/// How the fields of a line are separated and how numbers are written.
struct Separation {
  char delimiter = ' ';  ///< ' ': any run of blanks and tabs; else this character, optionally surrounded by blanks
  bool decimal_comma = false;

  /// Returns the fields without surrounding quotes and blanks.
  std::vector<std::string_view> split(std::string_view line) const;
  /// Thousands may be separated by commas (by points or apostrophes if there is a decimal comma).
  std::optional<double> number(std::string_view field) const;
};
/// Determined from one line of data: ';', tab, ',' or blanks; "1,5 2,5 3,5" and "1,5;2,5;3,5" have decimal commas.
Separation sniff_separation(std::string_view line);

/// Splits "Depth [ft]", "Z (m)" or "depth_ft" into the name in lower case and the unit, which is empty if there is
/// none.
std::pair<std::string, std::string> column_name_and_unit(std::string_view text);

/// The numbers, from 0, of the columns that are used.
struct Columns {
  std::size_t x = 0, y = 1, z = 2;
  std::optional<std::size_t> group;        ///< a name that divides the points into sets
  std::optional<std::size_t> stick;        ///< a number or name that divides the points of a set into lines
  std::optional<std::size_t> column, row;  ///< of a grid
  std::string group_name;
  bool depth = false, geographic = false;
  std::string z_unit;
};
/// Recognises columns by the names that are common in files ("X", "Easting [m]", "depth_ft", "formation"). Returns
/// nothing if x, y or z are not among them. Throws Error{invalid_input} at the line of `at` if z is a time.
std::optional<Columns> columns_by_name(const LineReader& at, const std::vector<std::string>& names);

/// Returns the meaning of each column according to the project's `columns`, whose entries refer to a name in the header
/// or to a number from 1; empty for other columns. Throws Error{invalid_input} at the line of `at` if there is no such
/// column.
std::vector<std::string> names_of_columns(const LineReader& at, const std::vector<ReadOptions::Column>& asked,
                                          const std::vector<std::string>& header, std::size_t n_columns);

/// Sets columns.group to the first column, in the order formation, surface, horizon, layer, unit, feature_name ... val,
/// that divides the following rows into at least two sets of three rows or more on average. `lines` is a copy, so the
/// position of the caller's reader does not change.
void choose_group(LineReader lines, const Separation& separation, const std::vector<std::string>& names,
                  Columns& columns);

/// One row of a table.
struct TableRow {
  Vec3 point;
  std::string group, stick;
  std::size_t column = 0, row = 0;  ///< column and row in a grid, from 0
};
struct Table {
  Columns columns;
  std::vector<TableRow> rows;
  std::size_t n_skipped = 0;  ///< number of rows without a value of x, y or z
  bool has_lines = false;     ///< whether the points form lines, separated by a column or by lines that begin with >
};
/// Reads the rows from the reader's next line on; blank lines and those that begin with # or ! are skipped, and one
/// that begins with > starts a new stick. `null`: heights of at least this size mean no value. Throws
/// Error{invalid_input} with the line if a field is missing or is not a number.
Table read_table(LineReader& lines, const Separation& separation, Columns columns,
                 double null = std::numeric_limits<double>::infinity());

/// Adds the point sets of the table, one for each group, or the lines of its sticks; a set that fills a regular lattice
/// becomes a surface instead. Coordinates are not converted; contents.frame is filled. Throws Error{invalid_input} if
/// there are no points.
void add_table(const InputFile& file, const Table& table, FileContents& contents);

/// Returns the points as a lattice if they are at the nodes of a regular one along x and y, of which at least a quarter
/// is present; otherwise nothing. Nodes keep their coordinates. O(n log n).
std::optional<NodeLattice> lattice_of_points(const std::vector<Vec3>& points);

}  // namespace geomesh::geomodel
