// SPDX-License-Identifier: GPL-3.0-or-later
// Reads points whose header defines the columns: EarthVision ("# Field: 1 x" ...; with "# Grid_size" and the fields
// column and row a grid) and Petrel points with attributes (VERSION, BEGIN HEADER, one name a line, END HEADER).
#include <algorithm>
#include <limits>

#include "readers/formats.hpp"
#include "readers/tables/table.hpp"
#include "readers/text/frame.hpp"

namespace geomesh::geomodel {
namespace {

/// Returns the text after the colon of a line "# Key: value"; empty if the line has another key.
std::string_view comment_value(std::string_view line, std::string_view key) {
  line = trim(line);
  if (line.empty() || line.front() != '#') return {};
  line = trim(line.substr(1));
  if (!starts_with_ignoring_case(line, key)) return {};
  line = trim(line.substr(key.size()));
  return line.starts_with(':') ? trim(line.substr(1)) : std::string_view{};
}

bool any_line(const InputFile& file, bool (*wanted)(std::string_view)) {
  LineReader lines(file);
  for (int n = 0; n < 200 && lines.next(); ++n) {
    if (wanted(lines.line())) return true;
    const std::string_view line = trim(lines.line());
    if (!line.empty() && line.front() != '#' && !line.starts_with("VERSION")) return false;
  }
  return false;
}

/// "10 x 20".
std::optional<std::pair<std::size_t, std::size_t>> grid_size(std::string_view value) {
  const std::string lower = to_lower(value);
  const std::size_t by = lower.find('x');
  if (by == std::string::npos) return std::nullopt;
  const auto nx = to_integer(trim(value.substr(0, by))), ny = to_integer(trim(value.substr(by + 1)));
  if (!nx || !ny || *nx < 2 || *ny < 2) return std::nullopt;
  return std::pair(static_cast<std::size_t>(*nx), static_cast<std::size_t>(*ny));
}

void skip_comments(LineReader& lines) {
  while (lines.next()) {
    const std::string_view line = trim(lines.line());
    if (!line.empty() && line.front() != '#') {
      lines.step_back();
      return;
    }
  }
}

struct EarthVisionHeader {
  std::vector<std::string> names;
  std::string unit, z_unit, projection;
  std::optional<std::pair<std::size_t, std::size_t>> size;
  double null = 1e30;
};

EarthVisionHeader earth_vision_header(LineReader lines) {
  EarthVisionHeader header;
  while (lines.next()) {
    const std::string_view line = trim(lines.line());
    if (line.empty()) continue;
    if (line.front() != '#') break;
    if (const auto v = comment_value(line, "Field"); !v.empty()) {
      Tokens tokens(v);
      const auto n = to_integer(tokens.next());
      if (!n || *n < 1 || *n > 1000) lines.fail("expected '# Field: NUMBER NAME', found " + in_quotes(line));
      header.names.resize(std::max(header.names.size(), static_cast<std::size_t>(*n)));
      header.names[static_cast<std::size_t>(*n) - 1] = tokens.next();
      const std::string_view unit = tokens.next();
      if (height_column(header.names[static_cast<std::size_t>(*n) - 1]).is_height && !unit.empty())
        header.z_unit = unit;
    }
    if (const auto v = comment_value(line, "Units"); !v.empty()) header.unit = v;
    if (const auto v = comment_value(line, "Z_units"); !v.empty() && header.z_unit.empty()) header.z_unit = v;
    if (const auto v = comment_value(line, "Projection"); !v.empty()) header.projection = v;
    if (const auto v = comment_value(line, "Grid_size"); !v.empty()) header.size = grid_size(v);
    if (const auto v = comment_value(line, "Null_value"); !v.empty()) header.null = to_double(v).value_or(1e30);
  }
  return header;
}

void add_grid(const InputFile& file, const Table& table, std::pair<std::size_t, std::size_t> size,
              FileContents& contents) {
  const auto [n_columns, n_rows] = size;
  if (n_columns > (std::size_t{1} << 31) / n_rows || n_columns * n_rows > 1000 * file.size()) {
    file.fail("Grid_size names " + std::to_string(n_columns) + " x " + std::to_string(n_rows) +
              " nodes, far more than the file holds");
  }
  const double none = std::numeric_limits<double>::quiet_NaN();
  NodeLattice lattice{n_columns, n_rows, std::vector<Vec3>(n_columns * n_rows, Vec3{none, none, none})};
  for (const TableRow& row : table.rows) {
    if (row.column >= n_columns || row.row >= n_rows) {
      file.fail("a point has column " + std::to_string(row.column + 1) + " and row " + std::to_string(row.row + 1) +
                ", but Grid_size is " + std::to_string(n_columns) + " x " + std::to_string(n_rows));
    }
    lattice.nodes[row.row * n_columns + row.column] = row.point;
  }
  if (table.n_skipped > 0) contents.notes.push_back(std::to_string(table.n_skipped) + " nodes have no value");
  add_lattice(file, file.path.stem().string(), lattice, {}, contents);
}

}  // namespace

bool is_earth_vision(const InputFile& file) {
  return any_line(file, [](std::string_view line) {
    return !comment_value(line, "Field").empty() || !comment_value(line, "Grid_size").empty();
  });
}

FileContents read_earth_vision(const InputFile& file) {
  LineReader lines(file);
  const EarthVisionHeader header = earth_vision_header(lines);
  skip_comments(lines);
  std::optional<Columns> columns = header.names.empty() ? Columns{} : columns_by_name(lines, header.names);
  if (!columns) file.fail("the header defines no fields x, y and z");
  LineReader ahead = lines;
  if (!ahead.next()) file.fail("the file ends within its header (truncated)");
  Separation separation = sniff_separation(ahead.line());
  choose_group(lines, separation, header.names, *columns);
  const bool by_column_and_row = header.size && columns->column && columns->row;
  const Table table = read_table(lines, separation, *columns, header.null);
  FileContents contents;
  contents.format = by_column_and_row ? "EarthVision grid" : "EarthVision points";
  if (by_column_and_row) {
    if (table.rows.empty()) file.fail("the grid is empty: no node has a value");
    add_grid(file, table, *header.size, contents);
  } else {
    add_table(file, table, contents);
  }
  contents.frame.unit = header.unit;
  if (contents.frame.z_unit.empty()) contents.frame.z_unit = header.z_unit;
  if (!starts_with_ignoring_case(header.projection, "Local")) contents.frame.crs = header.projection;
  convert_by_frame(file, contents);
  return contents;
}

bool is_petrel_points(const InputFile& file) {
  return any_line(file, [](std::string_view line) { return starts_with_ignoring_case(trim(line), "BEGIN HEADER"); });
}

FileContents read_petrel_points(const InputFile& file) {
  LineReader lines(file);
  FileContents contents;
  contents.format = "Petrel points";
  while (lines.next() && !starts_with_ignoring_case(trim(lines.line()), "BEGIN HEADER")) {
    if (const auto v = comment_value(lines.line(), "Unit in X and Y direction"); !v.empty()) contents.frame.unit = v;
    if (const auto v = comment_value(lines.line(), "Unit in depth"); !v.empty()) contents.frame.z_unit = v;
  }
  std::vector<std::string> names;
  bool ended = false;
  while (!ended && lines.next()) {
    std::string_view line = trim(lines.line());
    ended = starts_with_ignoring_case(line, "END HEADER");
    if (ended || line.empty() || line.front() == '#') continue;
    // Petrel writes an attribute as TYPE,NAME or TYPE "NAME".
    const std::size_t comma = line.find(','), quote = line.find('"');
    if (comma != std::string_view::npos)
      line = trim(line.substr(comma + 1));
    else if (quote != std::string_view::npos && quote > 0)
      line = trim(line.substr(quote));
    names.emplace_back(line.starts_with('"') && line.ends_with('"') && line.size() > 1 ? line.substr(1, line.size() - 2)
                                                                                       : line);
  }
  if (!ended) lines.fail("the file ends within BEGIN HEADER ... END HEADER (truncated)");
  std::optional<Columns> columns = columns_by_name(lines, names);
  if (!columns) file.fail("the header defines no columns X, Y and Z");
  choose_group(lines, Separation{}, names, *columns);
  const std::string z_unit = contents.frame.z_unit;
  add_table(file, read_table(lines, Separation{}, *columns), contents);
  if (contents.frame.z_unit.empty()) contents.frame.z_unit = z_unit;
  convert_by_frame(file, contents);
  return contents;
}

}  // namespace geomesh::geomodel
