// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/grids/grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "readers/text/no_data.hpp"

namespace geomesh::geomodel {
namespace {

constexpr std::size_t most_nodes = std::size_t{1} << 31;  // indices of points are stored as 32-bit numbers

/// Returns the cosine and sine of an angle, exact at multiples of 90 degrees.
std::pair<double, double> direction(double degrees) {
  const double turn = std::remainder(degrees, 360.0);
  if (turn == 0) return {1, 0};
  if (turn == 90) return {0, 1};
  if (turn == -90) return {0, -1};
  if (std::abs(turn) == 180) return {-1, 0};
  const double radians = turn * std::numbers::pi / 180;
  return {std::cos(radians), std::sin(radians)};
}

NodeLattice lattice_of(const Grid& grid) {
  NodeLattice lattice{grid.n_columns, grid.n_rows, {}};
  lattice.nodes.reserve(grid.heights.size());
  const auto [c, s] = direction(grid.rotation);
  for (std::size_t row = 0; row < grid.n_rows; ++row) {
    for (std::size_t column = 0; column < grid.n_columns; ++column) {
      const double u = static_cast<double>(column) * grid.dx, v = static_cast<double>(row) * grid.dy;
      lattice.nodes.push_back(
          {grid.x0 + (u * c - v * s), grid.y0 + (u * s + v * c), grid.heights[row * grid.n_columns + column]});
    }
  }
  return lattice;
}

void split_cell(const std::vector<Vec3>& nodes, const std::array<std::size_t, 4>& corner, Diagonal diagonal,
                std::vector<std::array<std::size_t, 3>>& out) {
  std::vector<std::size_t> present;
  for (const std::size_t c : corner)
    if (!std::isnan(nodes[c].z)) present.push_back(c);
  if (present.size() == 3) out.push_back({present[0], present[1], present[2]});
  if (present.size() < 4) return;
  const auto& [a, b, c, d] = corner;
  if (diagonal == Diagonal::from_first || std::abs(nodes[a].z - nodes[c].z) <= std::abs(nodes[b].z - nodes[d].z)) {
    out.push_back({a, b, c});
    out.push_back({a, c, d});
  } else {
    out.push_back({a, b, d});
    out.push_back({b, c, d});
  }
}

double doubled_map_area(const std::vector<Vec3>& nodes, const std::array<std::size_t, 3>& t) {
  const Vec3 u = nodes[t[1]] - nodes[t[0]], v = nodes[t[2]] - nodes[t[0]];
  return u.x * v.y - u.y * v.x;
}

}  // namespace

void allocate_heights(const InputFile& file, Grid& grid, std::size_t bytes_left, std::size_t least_bytes) {
  const std::string counts = std::to_string(grid.n_columns) + " columns and " + std::to_string(grid.n_rows) + " rows";
  if (grid.n_columns < 2 || grid.n_rows < 2) file.fail("the grid has " + counts + "; at least 2 of each were expected");
  const std::size_t most = std::min(bytes_left / least_bytes + 1, most_nodes);
  if (grid.n_columns > most || grid.n_rows > most / grid.n_columns) {
    file.fail("the header names " + counts + ", but only " + std::to_string(bytes_left) +
              " bytes of values follow (truncated, or a wrong count)");
  }
  grid.heights.assign(grid.n_columns * grid.n_rows, std::numeric_limits<double>::quiet_NaN());
}

double node_spacing(const InputFile& file, const char* axis, double low, double high, std::size_t n) {
  if (!(low < high) || !std::isfinite(high - low)) {
    file.fail(std::string("the limits of ") + axis + " are " + std::to_string(low) + " to " + std::to_string(high) +
              "; two different numbers, the lower first, were expected");
  }
  return (high - low) / static_cast<double>(std::max<std::size_t>(n, 2) - 1);
}

double read_height(TokenStream& tokens) {
  const std::string_view token = tokens.next();
  if (token.empty()) tokens.fail("the file ends where a height was expected (truncated, or a wrong count)");
  const auto value = to_double(token);
  if (!value) tokens.fail("expected a height, found " + in_quotes(token));
  return std::isfinite(*value) ? *value : std::numeric_limits<double>::quiet_NaN();
}

void expect_end_of_grid(TokenStream& tokens, const Grid& grid) {
  const std::string_view token = tokens.next();
  if (token.empty()) return;
  tokens.fail("the header names " + std::to_string(grid.n_columns) + " columns and " + std::to_string(grid.n_rows) +
              " rows, but more values follow: " + in_quotes(token));
}

void read_heights_below(double limit, TokenStream& tokens, Grid& grid) {
  for (double& h : grid.heights) {
    const double value = read_height(tokens);
    if (value < limit) h = value;
  }
  expect_end_of_grid(tokens, grid);
}

TriangulatedSurface triangulate_lattice(const NodeLattice& lattice, Diagonal diagonal, std::size_t& n_left_out) {
  std::vector<std::array<std::size_t, 3>> cells;
  for (std::size_t row = 0; row + 1 < lattice.n_rows; ++row) {
    for (std::size_t column = 0; column + 1 < lattice.n_columns; ++column) {
      const std::size_t a = row * lattice.n_columns + column, d = a + lattice.n_columns;
      split_cell(lattice.nodes, {a, a + 1, d + 1, d}, diagonal, cells);
    }
  }
  double area = 0;
  std::vector<bool> used(lattice.nodes.size(), false);
  for (const auto& t : cells) {
    area += doubled_map_area(lattice.nodes, t);
    for (const std::size_t v : t) used[v] = true;
  }
  TriangulatedSurface surface;
  std::vector<VertexIndex> row_of(lattice.nodes.size(), no_vertex);
  n_left_out = 0;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v]) {
      row_of[v] = static_cast<VertexIndex>(surface.points.size());
      surface.points.push_back(lattice.nodes[v]);
    } else if (!std::isnan(lattice.nodes[v].z)) {
      ++n_left_out;
    }
  }
  surface.triangles.reserve(cells.size());
  for (const auto& t : cells) {
    surface.triangles.push_back({row_of[t[0]], row_of[t[1]], row_of[t[2]]});
    if (area < 0) std::swap(surface.triangles.back()[1], surface.triangles.back()[2]);
  }
  return surface;
}

namespace {

void drop_no_data(const InputFile& file, const std::string& name, NodeLattice& lattice, FileContents& contents) {
  std::vector<double> heights;
  heights.reserve(lattice.nodes.size());
  for (const Vec3& p : lattice.nodes) heights.push_back(p.z);
  const std::vector<OddHeight> odd = find_odd_heights(heights, file.options);
  if (odd.empty()) return;
  for (std::string& text :
       describe_odd_heights(odd, name, "nodes", [&](std::size_t row) { return map_place_words(lattice.nodes[row]); }))
    contents.warnings.push_back(std::move(text));
  for (Vec3& p : lattice.nodes)
    if (is_left_out(p.z, odd)) p.z = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

void add_lattice(const InputFile& file, std::string name, NodeLattice lattice, GridSummary summary,
                 FileContents& contents) {
  drop_no_data(file, name, lattice, contents);
  add_checked_lattice(file, std::move(name), lattice, std::move(summary), contents);
}

void add_checked_lattice(const InputFile& file, std::string name, const NodeLattice& lattice, GridSummary summary,
                         FileContents& contents) {
  std::size_t n_left_out = 0;
  TriangulatedSurface surface = triangulate_lattice(lattice, Diagonal::of_less_relief, n_left_out);
  if (surface.triangles.empty()) file.fail("the grid is empty: no cell has three nodes with values");
  surface.name = std::move(name);
  surface.file = file.shown();
  summary.surface = surface.name;
  summary.n_columns = lattice.n_columns;
  summary.n_rows = lattice.n_rows;
  summary.n_blank = static_cast<std::size_t>(
      std::count_if(lattice.nodes.begin(), lattice.nodes.end(), [](const Vec3& p) { return std::isnan(p.z); }));
  if (n_left_out > 0) {
    contents.warnings.push_back(
        std::to_string(n_left_out) + " nodes of '" + surface.name +
        "' stand alone among nodes without a value: they belong to no triangle and are left out");
  }
  contents.grids.push_back(std::move(summary));
  contents.surfaces.push_back(std::move(surface));
}

FileContents grid_contents(const InputFile& file, std::string format, const Grid& grid) {
  for (const double v : {grid.x0, grid.y0, grid.dx, grid.dy, grid.rotation})
    if (!std::isfinite(v)) file.fail("the header of the grid holds a number that is not finite");
  if (!(grid.dx > 0) || !(grid.dy > 0)) {
    file.fail("the spacing of the grid is " + std::to_string(grid.dx) + " by " + std::to_string(grid.dy) +
              "; positive numbers were expected");
  }
  FileContents contents;
  contents.format = std::move(format);
  const std::string name = grid.name.empty() ? file.path.stem().string() : grid.name;
  add_lattice(file, name, lattice_of(grid),
              {name, 0, 0, 0, {grid.x0, grid.y0}, {grid.dx, grid.dy}, grid.rotation, grid.cell_centred}, contents);
  if (grid.cell_centred)
    contents.notes.push_back(
        "values of cells: they stand at the cells' centres, so the surface ends half a cell inside the raster");
  return contents;
}

}  // namespace geomesh::geomodel
