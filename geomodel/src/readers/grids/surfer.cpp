// SPDX-License-Identifier: GPL-3.0-or-later
// Reads Golden Software Surfer grids: DSAA (text), DSBB (Surfer 6, binary), DSRB (Surfer 7, binary, tagged sections).
// Values belong to nodes, rows are ordered from ylo upward; a value of 1.70141e38 or more is blank.
#include <algorithm>
#include <cmath>

#include "readers/formats.hpp"
#include "readers/grids/grid.hpp"
#include "readers/text/binary.hpp"

namespace geomesh::geomodel {
namespace {

constexpr double blank = 1.70141e38;

bool begins_with(const InputFile& file, std::string_view magic) { return file.text().substr(0, 4) == magic; }

void set_limits(const InputFile& file, Grid& grid, double x_low, double x_high, double y_low, double y_high) {
  grid.x0 = x_low;
  grid.y0 = y_low;
  grid.dx = node_spacing(file, "x", x_low, x_high, grid.n_columns);
  grid.dy = node_spacing(file, "y", y_low, y_high, grid.n_rows);
}

/// Reads the heights of a grid, values of type T from byte `at` on, row by row from the south. Values of `no_data` or
/// more mean that a node has no height.
template <class T>
void read_values(const InputFile& file, std::size_t at, double no_data, Grid& grid) {
  for (std::size_t i = 0; i < grid.heights.size(); ++i) {
    const double value = static_cast<double>(read_little<T>(file.bytes, at + sizeof(T) * i));
    if (std::isfinite(value) && value < no_data) grid.heights[i] = value;
  }
}

void expect_bytes(const InputFile& file, std::size_t needed) {
  if (file.size() < needed) {
    file.fail("the header needs a file of at least " + std::to_string(needed) + " bytes, this one has " +
              std::to_string(file.size()) + " (truncated)");
  }
}

}  // namespace

bool is_surfer_text(const InputFile& file) { return begins_with(file, "DSAA"); }
bool is_surfer_6(const InputFile& file) { return begins_with(file, "DSBB"); }
bool is_surfer_7(const InputFile& file) { return begins_with(file, "DSRB"); }

FileContents read_surfer_text(const InputFile& file) {
  TokenStream tokens(file);
  tokens.next();
  Grid grid;
  grid.n_columns = tokens.count("the number of columns", 1);
  grid.n_rows = tokens.count("the number of rows", 1);
  double limits[6];
  for (double& v : limits) v = tokens.number("a limit of x, y or z");
  allocate_heights(file, grid, tokens.bytes_left(), 2);
  set_limits(file, grid, limits[0], limits[1], limits[2], limits[3]);
  read_heights_below(blank, tokens, grid);
  return grid_contents(file, "Surfer grid (text)", grid);
}

FileContents read_surfer_6(const InputFile& file) {
  constexpr std::size_t header_bytes = 56;
  expect_bytes(file, header_bytes);
  Grid grid;
  const auto n_columns = read_little<std::int16_t>(file.bytes, 4), n_rows = read_little<std::int16_t>(file.bytes, 6);
  if (n_columns < 0 || n_rows < 0) file.fail("the header names a negative number of columns or rows");
  grid.n_columns = static_cast<std::size_t>(n_columns);
  grid.n_rows = static_cast<std::size_t>(n_rows);
  allocate_heights(file, grid, file.size() - header_bytes, sizeof(float));
  expect_bytes(file, header_bytes + sizeof(float) * grid.heights.size());
  double limits[4];
  for (std::size_t i = 0; i < 4; ++i) limits[i] = read_little<double>(file.bytes, 8 + 8 * i);
  set_limits(file, grid, limits[0], limits[1], limits[2], limits[3]);
  read_values<float>(file, header_bytes, blank, grid);
  FileContents contents = grid_contents(file, "Surfer 6 grid", grid);
  if (file.size() > header_bytes + sizeof(float) * grid.heights.size())
    contents.warnings.push_back("bytes behind the last value are ignored");
  return contents;
}

namespace {

constexpr std::uint32_t grid_section = 0x44495247, data_section = 0x41544144, fault_section = 0x49544c46;

void read_grid_section(const InputFile& file, std::size_t at, Grid& grid, double& no_data) {
  const auto n_rows = read_little<std::int32_t>(file.bytes, at),
             n_columns = read_little<std::int32_t>(file.bytes, at + 4);
  if (n_columns < 0 || n_rows < 0) file.fail("the header names a negative number of columns or rows");
  grid.n_columns = static_cast<std::size_t>(n_columns);
  grid.n_rows = static_cast<std::size_t>(n_rows);
  grid.x0 = read_little<double>(file.bytes, at + 8);
  grid.y0 = read_little<double>(file.bytes, at + 16);
  grid.dx = read_little<double>(file.bytes, at + 24);
  grid.dy = read_little<double>(file.bytes, at + 32);
  const double rotation = read_little<double>(file.bytes, at + 56);
  if (rotation != 0)
    file.fail("the grid is rotated by " + std::to_string(rotation) +
              " degrees, which the format reserves and leaves without a meaning");
  no_data = read_little<double>(file.bytes, at + 64);
}

}  // namespace

FileContents read_surfer_7(const InputFile& file) {
  Grid grid;
  double no_data = blank;
  bool has_grid = false, has_data = false, has_faults = false;
  for (std::size_t at = 0; at + 8 <= file.size();) {
    const auto tag = read_little<std::uint32_t>(file.bytes, at);
    const auto size = static_cast<std::size_t>(read_little<std::uint32_t>(file.bytes, at + 4));
    at += 8;
    if (size > file.size() - at) {
      file.fail("a section of " + std::to_string(size) + " bytes begins at byte " + std::to_string(at) +
                ", but the file ends at " + std::to_string(file.size()) + " (truncated)");
    }
    if (tag == grid_section) {
      if (size < 72) file.fail("the section GRID has " + std::to_string(size) + " bytes; 72 were expected");
      read_grid_section(file, at, grid, no_data);
      has_grid = true;
    } else if (tag == data_section && has_grid && !has_data) {
      allocate_heights(file, grid, size, sizeof(double));
      if (size != sizeof(double) * grid.heights.size()) {
        file.fail("the section DATA has " + std::to_string(size) + " bytes; " +
                  std::to_string(sizeof(double) * grid.heights.size()) + " were expected");
      }
      read_values<double>(file, at, std::min(no_data > 0 ? no_data : blank, blank), grid);
      if (no_data <= 0)
        for (double& h : grid.heights)
          if (h == no_data) h = std::nan("");
      has_data = true;
    }
    has_faults = has_faults || tag == fault_section;
    at += size;
  }
  if (!has_data) file.fail("the sections GRID and DATA are not both there (truncated)");
  FileContents contents = grid_contents(file, "Surfer 7 grid", grid);
  if (has_faults) contents.warnings.push_back("fault traces of the grid are passed over");
  return contents;
}

}  // namespace geomesh::geomodel
