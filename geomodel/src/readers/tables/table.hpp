// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Tables of points in text: how their fields are parted, what their columns mean, and what becomes of them.
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

/// How the fields of a line are parted and numbers are written.
struct Separation {
  char delimiter = ' ';  ///< ' ': any run of blanks and tabs; else this character, around which blanks are allowed
  bool decimal_comma = false;

  /// Fields without quotes and blanks around them.
  std::vector<std::string_view> split(std::string_view line) const;
  /// Thousands may be parted by commas (by points or apostrophes where there is a decimal comma).
  std::optional<double> number(std::string_view field) const;
};
/// Told from one line of data: ';', tab, ',' or blanks; "1,5 2,5 3,5" and "1,5;2,5;3,5" have decimal commas.
Separation sniff_separation(std::string_view line);

/// "Depth [ft]", "Z (m)", "depth_ft": the name in lower case, and its unit; an empty unit where there is none.
std::pair<std::string, std::string> column_name_and_unit(std::string_view text);

/// Which columns (from 0) matter.
struct Columns {
  std::size_t x = 0, y = 1, z = 2;
  std::optional<std::size_t> group;        ///< a name that parts the points into sets
  std::optional<std::size_t> stick;        ///< a number or name that divides the points of a set into lines
  std::optional<std::size_t> column, row;  ///< of a grid
  std::string group_name;
  bool depth = false, geographic = false;
  std::string z_unit;
};
/// From names as files write them ("X", "Easting [m]", "depth_ft", "formation"). Empty where x, y or z are not among
/// them. Throws Error{invalid_input} at the line of `at` where z is a time.
std::optional<Columns> columns_by_name(const LineReader& at, const std::vector<std::string>& names);

/// What the columns of a table mean by the project's `columns`: the meanings at the places that its entries name, by a
/// name of the header or a number from 1; empty names elsewhere. Throws Error{invalid_input} at the line of `at` where
/// there is no such column.
std::vector<std::string> names_of_columns(const LineReader& at, const std::vector<ReadOptions::Column>& asked,
                                          const std::vector<std::string>& header, std::size_t n_columns);

/// Sets columns.group to the first column, in the order formation, surface, horizon, layer, unit, feature_name ... val,
/// that parts the rows to come into at least two sets of three rows or more on average. `lines` is a copy: the caller's
/// stays where it is.
void choose_group(LineReader lines, const Separation& separation, const std::vector<std::string>& names,
                  Columns& columns);

/// One row of a table.
struct TableRow {
  Vec3 point;
  std::string group, stick;
  std::size_t column = 0, row = 0;  ///< of a grid, from 0
};
struct Table {
  Columns columns;
  std::vector<TableRow> rows;
  std::size_t n_skipped = 0;  ///< rows without a value of x, y or z
  bool has_lines = false;     ///< the points are of lines, parted by a column or by lines that begin with >
};
/// The rows from the reader's next line on; blank lines and those that begin with # or ! are passed over, and one that
/// begins with > begins a new stick. `null`:
/// heights of this size and more have no value. Throws Error{invalid_input} with the line where a field is no number or
/// missing.
Table read_table(LineReader& lines, const Separation& separation, Columns columns,
                 double null = std::numeric_limits<double>::infinity());

/// Point sets of the table, one a group, or the lines of its sticks; a set that fills a regular lattice becomes a
/// surface instead. Coordinates are
/// not converted; contents.frame is filled. Throws Error{invalid_input} where there is no point.
void add_table(const InputFile& file, const Table& table, FileContents& contents);

/// The points as a lattice. They must stand at the nodes of a regular one along x and y, of which at least a quarter
/// is present. Nodes keep their coordinates. Empty otherwise. O(n log n).
std::optional<NodeLattice> lattice_of_points(const std::vector<Vec3>& points);

}  // namespace geomesh::geomodel
