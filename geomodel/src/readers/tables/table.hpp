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

/// The format of a table's lines: how fields are separated and how numbers are written.
struct Separation {
  /// separator of fields: ' ' for any run of blanks and tabs, else one that blanks may surround
  char delimiter = ' ';
  bool decimal_comma = false;

  /// Splits a line into fields, without the quotes and blanks around them.
  std::vector<std::string_view> split(std::string_view line) const;
  /// Converts a field to a number. Commas may separate thousands (points or apostrophes if there is a decimal comma).
  std::optional<double> number(std::string_view field) const;
};
/// Determines the separator of fields from one line of data: ';', tab, ',' or blanks. Lines such as "1,5 2,5 3,5" and
/// "1,5;2,5;3,5" have decimal commas.
Separation sniff_separation(std::string_view line);

/// Splits "Depth [ft]", "Z (m)" or "depth_ft" into the name in lower case and the unit, which is empty if there is
/// none.
std::pair<std::string, std::string> column_name_and_unit(std::string_view text);

/// Numbers, from 0, of the columns of a table that are used.
struct Columns {
  std::size_t x = 0, y = 1, z = 2;
  std::optional<std::size_t> group;        ///< column of names that divide the points into sets
  std::optional<std::size_t> stick;        ///< column of numbers or names that divide the points of a set into lines
  std::optional<std::size_t> column, row;  ///< of a grid
  std::string group_name;
  bool depth = false, geographic = false;
  std::string z_unit;
};
/// Recognises the columns of a table by names that are common in files ("X", "Easting [m]", "depth_ft", "formation").
/// Returns nothing if x, y or z are not among them. Throws Error{invalid_input} at the line of `at` if z is a time.
std::optional<Columns> columns_by_name(const LineReader& at, const std::vector<std::string>& names);

/// Returns the meaning of each column of a table according to the key `columns` of the project, which identifies
/// columns by their name in the header or by number from 1; empty for columns that it does not list. Throws
/// Error{invalid_input} at the line of `at` if there is no such column.
std::vector<std::string> names_of_columns(const LineReader& at, const std::vector<ReadOptions::Column>& asked,
                                          const std::vector<std::string>& header, std::size_t n_columns);

/// Sets columns.group to the first column, in the order formation, surface, horizon, layer, unit, feature_name ... val,
/// that divides the table's rows into at least two sets of on average three rows or more. `lines` is a copy, so that
/// the position of the caller's reader does not change.
void choose_group(LineReader lines, const Separation& separation, const std::vector<std::string>& names,
                  Columns& columns);

struct TableRow {
  Vec3 point;
  std::string group, stick;
  std::size_t column = 0, row = 0;  ///< column and row of the point in a grid, from 0
};
struct Table {
  Columns columns;
  std::vector<TableRow> rows;
  std::size_t n_skipped = 0;  ///< number of table rows without a value of x, y or z
  /// Whether the points form lines: they are separated by a column of the table or by lines of text that begin with >.
  bool has_lines = false;
};
/// Reads the rows of a table from the reader's next line on. Blank lines and those that begin with # or ! are skipped;
/// one that begins with > starts a new polyline. Heights whose absolute value is at least `null` mean no value. Throws
/// Error{invalid_input} with the line if a field is missing or is not a number.
Table read_table(LineReader& lines, const Separation& separation, Columns columns,
                 double null = std::numeric_limits<double>::infinity());

/// Adds the point sets of the table, one for each group, or the lines of its sticks; a set that fills a regular grid
/// becomes a surface instead. Coordinates are not converted; contents.frame describes them. Throws Error{invalid_input}
/// if there are no points.
void add_table(const InputFile& file, const Table& table, FileContents& contents);

/// Returns points as a grid if they are at the nodes of a regular grid along x and y of which at least a quarter is
/// present; otherwise nothing. Nodes keep the coordinates of the points. O(n log n).
std::optional<NodeLattice> lattice_of_points(const std::vector<Vec3>& points);

}  // namespace geomesh::geomodel
