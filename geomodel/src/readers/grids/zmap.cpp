// SPDX-License-Identifier: GPL-3.0-or-later
// Reads ZMAP+ grids: comments (!), a header between two @, values in fields of fixed width without separators. Values
// belong to nodes.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "readers/formats.hpp"
#include "readers/grids/column_grid.hpp"

namespace geomesh::geomodel {
namespace {

struct Layout {
  std::size_t width = 0;         ///< width of a field in characters; 0: fields are separated by blanks
  std::size_t first_column = 1;  ///< position in a line of a ZMAP+ file at which the first field begins, from 1
  int decimals = 0;              ///< a height without a decimal point is divided by 10 to the power of this number
  std::optional<double> null;
  std::string null_text;
};

std::vector<std::string> comma_fields(std::string_view line) {
  std::vector<std::string> fields;
  for (;;) {
    const std::size_t comma = line.find(',');
    fields.emplace_back(trim(line.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

std::vector<std::string> header_line(LineReader& lines, std::size_t least_fields, const char* what) {
  while (lines.next()) {
    const std::string_view line = trim(lines.line());
    if (line.empty() || line.front() == '!') continue;
    std::vector<std::string> fields = comma_fields(line);
    if (fields.size() < least_fields) lines.fail(std::string("expected ") + what + ", found " + in_quotes(line));
    return fields;
  }
  lines.fail(std::string("the file ends where ") + what + " was expected (truncated)");
}

double number(const LineReader& lines, const std::string& field, const char* what) {
  return finite_number(lines, field, what);
}

std::size_t count(const LineReader& lines, const std::string& field, const char* what) {
  const auto n = to_integer(field);
  if (!n || *n < 0) lines.fail(std::string("expected ") + what + ", found " + in_quotes(field));
  return static_cast<std::size_t>(*n);
}

Layout read_layout(LineReader& lines) {
  const std::vector<std::string> fields = header_line(lines, 5, "width, null value, null text, decimals, start column");
  Layout layout;
  layout.width = count(lines, fields[0], "the width of a field");
  if (const auto null = to_double(fields[1])) layout.null = *null;
  layout.null_text = fields[2];
  if (!layout.null) layout.null = to_double(layout.null_text);
  if (!fields[3].empty())
    layout.decimals = static_cast<int>(std::min<std::size_t>(count(lines, fields[3], "the number of decimals"), 30));
  if (!fields[4].empty()) layout.first_column = std::max<std::size_t>(count(lines, fields[4], "the start column"), 1);
  return layout;
}

/// Returns the number in a token of a ZMAP+ file; NaN if the token means no value, and nothing if it is not a number.
std::optional<double> value_of(std::string_view token, const Layout& layout) {
  if (!layout.null_text.empty() && token == layout.null_text) return std::numeric_limits<double>::quiet_NaN();
  auto value = to_double(token);
  if (!value) return std::nullopt;
  if (!std::isfinite(*value) || (layout.null && is_null(*value, *layout.null)))
    return std::numeric_limits<double>::quiet_NaN();
  if (layout.decimals > 0 && token.find_first_of(".eEdD") == std::string_view::npos)
    *value /= std::pow(10.0, layout.decimals);
  return value;
}

/// Reads ZMAP+ values that are separated by blanks. Returns false if a token is not a number or is wider than a field.
bool by_blanks(std::string_view line, const Layout& layout, std::vector<double>& values) {
  Tokens tokens(line);
  for (std::string_view token = tokens.next(); !token.empty(); token = tokens.next()) {
    const auto value = value_of(token, layout);
    if (!value || (layout.width > 0 && token.size() > layout.width)) return false;
    values.push_back(*value);
  }
  return true;
}

bool by_width(std::string_view line, const Layout& layout, std::vector<double>& values) {
  if (layout.width == 0) return false;
  for (std::size_t at = layout.first_column - 1; at < line.size(); at += layout.width) {
    const std::string_view token = trim(line.substr(at, layout.width));
    if (token.empty()) continue;
    const auto value = value_of(token, layout);
    if (!value) return false;
    values.push_back(*value);
  }
  return true;
}

void read_values(LineReader& lines, const Layout& layout, Grid& grid) {
  ColumnMajorFill fill(grid);
  std::vector<double> values;
  while (lines.next()) {
    const std::string_view line = lines.line();
    if (!trim(line).empty() && trim(line).front() == '!') continue;
    values.clear();
    if (!by_blanks(line, layout, values)) {
      values.clear();
      if (!by_width(line, layout, values))
        lines.fail("expected heights in fields of " + std::to_string(layout.width) + " characters, found " +
                   in_quotes(line));
    }
    for (const double v : values) {
      if (fill.full())
        lines.fail("the header names " + std::to_string(grid.heights.size()) + " heights, but more values follow");
      fill.add(v);
    }
  }
  if (!fill.full()) {
    lines.fail("the header names " + std::to_string(grid.heights.size()) + " heights, but the file ends after " +
               std::to_string(fill.count()) + " (truncated)");
  }
}

}  // namespace

bool is_null(double value, double null) { return std::abs(value - null) <= 1e-5 * std::abs(null); }

bool is_zmap(const InputFile& file) {
  LineReader lines(file);
  for (int n = 0; n < 1000 && lines.next(); ++n) {
    const std::string_view line = trim(lines.line());
    if (line.empty() || line.front() == '!') continue;
    return line.front() == '@' && to_lower(line).find("grid") != std::string::npos;
  }
  return false;
}

FileContents read_zmap(const InputFile& file) {
  LineReader lines(file);
  const std::vector<std::string> title = header_line(lines, 2, "@name, GRID, nodes per line");
  const Layout layout = read_layout(lines);
  const std::vector<std::string> size = header_line(lines, 6, "rows, columns, xmin, xmax, ymin, ymax");
  Grid grid;
  grid.name = trim(std::string_view(title[0]).substr(1));
  if (const std::size_t word = to_lower(grid.name).rfind(" header"); word != std::string::npos)
    grid.name = trim(std::string_view(grid.name).substr(0, word));
  grid.n_rows = count(lines, size[0], "the number of rows");
  grid.n_columns = count(lines, size[1], "the number of columns");
  grid.x0 = number(lines, size[2], "xmin");
  grid.dx = node_spacing(file, "x", grid.x0, number(lines, size[3], "xmax"), grid.n_columns);
  grid.y0 = number(lines, size[4], "ymin");
  grid.dy = node_spacing(file, "y", grid.y0, number(lines, size[5], "ymax"), grid.n_rows);
  while (header_line(lines, 1, "the @ that ends the header").front() != "@") {
  }
  allocate_heights(file, grid, file.size(), 1);
  read_values(lines, layout, grid);
  return grid_contents(file, "ZMAP+ grid", grid);
}

}  // namespace geomesh::geomodel
