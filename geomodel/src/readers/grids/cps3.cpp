// SPDX-License-Identifier: GPL-3.0-or-later
// Reads CPS-3 ASCII grids: records FSASCI (null value), FSLIMI, FSNROW, FSXINC, a line ->name, then values. Values
// belong to nodes.
#include <cmath>
#include <limits>

#include "readers/formats.hpp"
#include "readers/grids/column_grid.hpp"

namespace geomesh::geomodel {
namespace {

struct Header {
  double null = 1e30;
  double limits[4];
  double spacing[2];
  std::size_t n_rows = 0, n_columns = 0;
  bool has_limits = false, has_counts = false, has_spacing = false;
  std::string name;
};

std::size_t count(const LineReader& lines, std::string_view token, const char* what) {
  const auto n = to_integer(token);
  if (!n || *n < 0) lines.fail(std::string("expected ") + what + ", found " + in_quotes(token));
  return static_cast<std::size_t>(*n);
}

/// Reads a line as a record of a CPS-3 header. Returns false if it is none, because the grid's values begin there.
bool header_record(const LineReader& lines, Header& header) {
  Tokens tokens(lines.line());
  const std::string_view key = tokens.next();
  if (key == "FSASCI") {
    std::string_view last;
    for (int i = 0; i < 5; ++i) last = tokens.next_quoted();
    if (const auto null = to_double(last)) header.null = *null;
  } else if (key == "FSLIMI") {
    static constexpr const char* what[4] = {"xmin", "xmax", "ymin", "ymax"};
    for (std::size_t i = 0; i < 4; ++i) header.limits[i] = finite_number(lines, tokens.next(), what[i]);
    header.has_limits = true;
  } else if (key == "FSNROW") {
    header.n_rows = count(lines, tokens.next(), "the number of rows");
    header.n_columns = count(lines, tokens.next(), "the number of columns");
    header.has_counts = true;
  } else if (key == "FSXINC") {
    for (double& d : header.spacing) d = finite_number(lines, tokens.next(), "the spacing");
    header.has_spacing = true;
  } else if (key.starts_with("->")) {
    header.name = trim(trim(lines.line()).substr(2));
  } else if (!key.empty() && key.front() != '!' && !key.starts_with("FS")) {
    return false;
  }
  return true;
}

void read_values(LineReader& lines, double null, Grid& grid) {
  ColumnMajorFill fill(grid);
  lines.step_back();
  while (lines.next()) {
    Tokens tokens(lines.line());
    for (std::string_view token = tokens.next(); !token.empty() && token.front() != '!'; token = tokens.next()) {
      const auto value = to_double(token);
      if (!value) lines.fail("expected a height, found " + in_quotes(token));
      if (fill.full())
        lines.fail("the header names " + std::to_string(grid.heights.size()) + " heights, but more values follow");
      fill.add(!std::isfinite(*value) || is_null(*value, null) ? std::numeric_limits<double>::quiet_NaN() : *value);
    }
  }
  if (!fill.full()) {
    lines.fail("the header names " + std::to_string(grid.heights.size()) + " heights, but the file ends after " +
               std::to_string(fill.count()) + " (truncated)");
  }
}

}  // namespace

bool is_cps3(const InputFile& file) {
  LineReader lines(file);
  for (int n = 0; n < 1000 && lines.next(); ++n) {
    const std::string_view line = trim(lines.line());
    if (line.empty() || line.front() == '!') continue;
    return line.starts_with("FSASCI");
  }
  return false;
}

FileContents read_cps3(const InputFile& file) {
  LineReader lines(file);
  Header header;
  bool has_values = false;
  while (!has_values && lines.next()) has_values = !header_record(lines, header);
  if (!has_values) lines.fail("the file ends within its header (truncated)");
  if (!header.has_limits || !header.has_counts)
    lines.fail("values begin before the records FSLIMI and FSNROW have both been given");
  Grid grid;
  grid.name = header.name;
  grid.n_rows = header.n_rows;
  grid.n_columns = header.n_columns;
  grid.x0 = header.limits[0];
  grid.y0 = header.limits[2];
  grid.dx = node_spacing(file, "x", header.limits[0], header.limits[1], grid.n_columns);
  grid.dy = node_spacing(file, "y", header.limits[2], header.limits[3], grid.n_rows);
  allocate_heights(file, grid, file.size(), 1);
  read_values(lines, header.null, grid);
  FileContents contents = grid_contents(file, "CPS-3 grid", grid);
  const bool contradiction = header.has_spacing && (std::abs(header.spacing[0] - grid.dx) > 1e-3 * grid.dx ||
                                                    std::abs(header.spacing[1] - grid.dy) > 1e-3 * grid.dy);
  if (contradiction)
    contents.warnings.push_back("FSXINC does not agree with FSLIMI and FSNROW; the nodes stand by the latter two");
  return contents;
}

}  // namespace geomesh::geomodel
