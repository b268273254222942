// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Grids of heights as contained in files, and their conversion to surfaces with holes.
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/surface.hpp"
#include "readers/text/input_file.hpp"
#include "readers/text/text.hpp"

namespace geomesh::geomodel {

/// Heights at nodes in columns and rows. For files whose values belong to cells (rasters) the nodes are the cells'
/// centres.
struct Grid {
  std::string name;
  std::size_t n_columns = 0, n_rows = 0;
  double x0 = 0, y0 = 0;  ///< position of the node in column 0, row 0: the south-west node if the rotation is 0
  double dx = 0, dy = 0;  ///< between nodes, positive
  double rotation = 0;  ///< direction of ascending grid columns in degrees counter-clockwise from east, about (x0, y0)
  bool cell_centred = false;
  std::vector<double> heights;  ///< height of the grid node at index row * n_columns + column; NaN if it has none

  double& at(std::size_t column, std::size_t row) { return heights[row * n_columns + column]; }
};

/// A grid of nodes in columns and rows, which may be at any positions.
struct NodeLattice {
  std::size_t n_columns = 0, n_rows = 0;
  std::vector<Vec3> nodes;  ///< grid node at index row * n_columns + column; z is NaN if it has no height
};

/// Allocates the heights of a grid and sets all to NaN. Before, the numbers of columns and rows in the file's header
/// are compared with the rest of the file, `bytes_left` bytes with at least `least_bytes` for each value. Throws
/// Error{invalid_input} if there are fewer than two columns or rows, or more values than the rest can contain.
void allocate_heights(const InputFile& file, Grid& grid, std::size_t bytes_left, std::size_t least_bytes);

/// Returns the spacing of n nodes from `low` to `high`. Throws Error{invalid_input} if these limits along `axis` ("x",
/// "y") are equal or in the wrong order.
double node_spacing(const InputFile& file, const char* axis, double low, double high, std::size_t n);

/// Reads the next height of a text grid. NaN and infinite numbers become NaN; throws if the word is no number.
double read_height(TokenStream& tokens);
/// Throws Error{invalid_input} if the file continues after the last value of the grid.
void expect_end_of_grid(TokenStream& tokens, const Grid& grid);
/// Reads all heights of a text grid in the order of the file, up to its end. Values of `limit` or more mean "no
/// height".
void read_heights_below(double limit, TokenStream& tokens, Grid& grid);

/// Choice of the diagonal along which a grid cell of four nodes is divided into two triangles.
enum class Diagonal {
  of_less_relief,  ///< the diagonal with the smaller height difference, which follows ridges and valleys
  from_first,      ///< the diagonal of a grid cell from its first node to the opposite one
};

/// Triangulates a grid of nodes. A cell has two triangles, one if one of its four nodes has no height, and none if more
/// have none. Normals point up. Unused nodes are left out and counted.
TriangulatedSurface triangulate_lattice(const NodeLattice& lattice, Diagonal diagonal, std::size_t& n_left_out);

/// Converts a grid to the contents of a file with one surface and notes on its interpretation. Throws
/// Error{invalid_input} if no cell has heights at all of its nodes.
FileContents grid_contents(const InputFile& file, std::string format, const Grid& grid);

/// Appends a grid of nodes as a surface, and adds its counts to `summary`. Heights that mean "no value" although the
/// header does not say so are left out with a warning (readers/text/no_data.hpp). Throws Error{invalid_input} if no
/// cell has heights at all of its nodes.
void add_lattice(const InputFile& file, std::string name, NodeLattice lattice, GridSummary summary,
                 FileContents& contents);

/// Appends a grid of nodes as a surface like add_lattice, but without examining its heights, as the caller has.
void add_checked_lattice(const InputFile& file, std::string name, const NodeLattice& lattice, GridSummary summary,
                         FileContents& contents);

}  // namespace geomesh::geomodel
