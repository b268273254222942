// SPDX-License-Identifier: GPL-3.0-or-later
// Reads ESRI ASCII rasters (Arc/Info ASCIIGRID): keys in any case and order, then rows from the north. Values belong to
// cells: xllcorner is the edge of a cell, xllcenter its centre. Line breaks have no meaning; decimal commas occur.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "readers/formats.hpp"
#include "readers/grids/grid.hpp"

namespace geomesh::geomodel {
namespace {

/// Returns the number in a token of an ESRI ASCII raster, in which a comma may stand for the decimal point.
std::optional<double> number_with_comma(std::string_view token) {
  if (const auto value = to_double(token)) return value;
  std::string copy(token);
  if (std::count(copy.begin(), copy.end(), ',') != 1) return std::nullopt;
  std::replace(copy.begin(), copy.end(), ',', '.');
  return to_double(copy);
}

double number_of(TokenStream& tokens, std::string_view token, const std::string& what) {
  if (token.empty()) tokens.fail("the file ends where " + what + " was expected (truncated)");
  const auto value = number_with_comma(token);
  if (!value) tokens.fail("expected " + what + ", found " + in_quotes(token));
  return *value;
}

struct Header {
  std::optional<double> n_columns, n_rows, x_corner, y_corner, x_centre, y_centre, cell, dx, dy, no_data;

  std::optional<double>* field(std::string_view key) {
    const std::string k = to_lower(key);
    if (k == "ncols") return &n_columns;
    if (k == "nrows") return &n_rows;
    if (k == "xllcorner") return &x_corner;
    if (k == "yllcorner") return &y_corner;
    if (k == "xllcenter" || k == "xllcentre") return &x_centre;
    if (k == "yllcenter" || k == "yllcentre") return &y_centre;
    if (k == "cellsize") return &cell;
    if (k == "dx") return &dx;
    if (k == "dy") return &dy;
    if (k == "nodata_value" || k == "nodata") return &no_data;
    return nullptr;
  }
};

std::size_t whole_count(const InputFile& file, const std::optional<double>& n, const char* key) {
  if (!n || !(*n >= 0) || *n != std::floor(*n) || *n > 1e15) file.fail(std::string(key) + " is missing or no count");
  return static_cast<std::size_t>(*n);
}

/// Returns the position of the first node of a raster: the given corner of the first cell plus half a cell, or the
/// given centre of the cell.
double first_node(const InputFile& file, const std::optional<double>& corner, const std::optional<double>& centre,
                  double size, const char* key) {
  if (corner.has_value() == centre.has_value())
    file.fail(std::string(key) + "corner or " + key + "center was expected, one of them");
  return corner ? *corner + size / 2 : *centre;
}

}  // namespace

bool is_esri_ascii(const InputFile& file) {
  Tokens tokens(trim(file.text().substr(0, 256)));
  const std::string_view key = tokens.next();
  return equals_ignoring_case(key, "ncols") || equals_ignoring_case(key, "nrows");
}

FileContents read_esri_ascii(const InputFile& file) {
  TokenStream tokens(file);
  Header header;
  std::string_view token = tokens.next();
  for (; !number_with_comma(token); token = tokens.next()) {
    std::optional<double>* field = header.field(token);
    if (token.empty()) tokens.fail("the file ends within its header (truncated)");
    if (!field)
      tokens.fail("expected a key of the header (ncols, nrows, xllcorner ...) or a height, found " + in_quotes(token));
    const std::string key(token);
    *field = number_of(tokens, tokens.next(), "the value of " + key);
  }
  Grid grid;
  grid.cell_centred = true;
  grid.n_columns = whole_count(file, header.n_columns, "ncols");
  grid.n_rows = whole_count(file, header.n_rows, "nrows");
  if (!header.cell && !(header.dx && header.dy)) file.fail("cellsize is missing");
  grid.dx = header.dx.value_or(header.cell.value_or(0));
  grid.dy = header.dy.value_or(header.cell.value_or(0));
  grid.x0 = first_node(file, header.x_corner, header.x_centre, grid.dx, "xll");
  grid.y0 = first_node(file, header.y_corner, header.y_centre, grid.dy, "yll");
  allocate_heights(file, grid, tokens.bytes_left() + token.size(), 2);
  const double no_data = header.no_data.value_or(-9999);
  for (std::size_t row = grid.n_rows; row-- > 0;) {
    for (std::size_t column = 0; column < grid.n_columns; ++column) {
      const double value = number_of(tokens, token, "a height");
      if (std::isfinite(value) && value != no_data && !(no_data < -1e37 && value < -1e37)) grid.at(column, row) = value;
      token = tokens.next();
    }
  }
  if (!token.empty())
    tokens.fail("the header names " + std::to_string(grid.n_columns * grid.n_rows) +
                " heights, but more values follow: " + in_quotes(token));
  return grid_contents(file, "ESRI ASCII grid", grid);
}

}  // namespace geomesh::geomodel
