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
  double x0 = 0, y0 = 0;  ///< position of the node in column 0, row 0: the south-west one if the rotation is 0
  double dx = 0, dy = 0;  ///< between nodes, positive
  double rotation = 0;    ///< direction of ascending columns, in degrees counter-clockwise from east, about (x0, y0)
  bool cell_centred = false;
  std::vector<double> heights;  ///< row * n_columns + column; NaN if the node has none

  double& at(std::size_t column, std::size_t row) { return heights[row * n_columns + column]; }
};

/// Nodes in columns and rows, at any positions.
struct NodeLattice {
  std::size_t n_columns = 0, n_rows = 0;
  std::vector<Vec3> nodes;  ///< row * n_columns + column; z is NaN if the node has none
};

/// Checks the counts of a header against the rest of the file (`bytes_left` bytes of at least `least_bytes` per value)
/// before heights are allocated; all become NaN. Throws Error{invalid_input} if there are fewer than two columns or
/// rows, or more than can follow.
void allocate_heights(const InputFile& file, Grid& grid, std::size_t bytes_left, std::size_t least_bytes);

/// Returns the spacing of n nodes. Throws Error{invalid_input} if the limits along `axis` ("x", "y") are equal or in
/// the wrong order.
double node_spacing(const InputFile& file, const char* axis, double low, double high, std::size_t n);

/// Returns the next height of a text grid; NaN if the token means that or is infinite. Throws if it is not a number.
double read_height(TokenStream& tokens);
/// Throws Error{invalid_input} if anything follows the last value.
void expect_end_of_grid(TokenStream& tokens, const Grid& grid);
/// Reads all heights of a text grid in the file's order, and its end; nodes with a value of `limit` or more have none.
void read_heights_below(double limit, TokenStream& tokens, Grid& grid);

/// How a cell of four nodes is divided into triangles.
enum class Diagonal {
  of_less_relief,  ///< along the smaller height difference, which follows ridges and valleys
  from_first,      ///< from its first node to the opposite one
};

/// Returns two triangles per cell of four nodes; one if one node is missing; none if more are. Normals point up. Unused
/// nodes are left out and counted.
TriangulatedSurface triangulate_lattice(const NodeLattice& lattice, Diagonal diagonal, std::size_t& n_left_out);

/// Returns the grid as the only surface of its file, with notes on its interpretation. Throws Error{invalid_input} if
/// no cell is complete.
FileContents grid_contents(const InputFile& file, std::string format, const Grid& grid);

/// Appends a lattice as a surface; `summary` is completed with its counts. Heights that mean "no value" although the
/// header does not say so are left out with a warning (readers/text/no_data.hpp). Throws as above.
void add_lattice(const InputFile& file, std::string name, NodeLattice lattice, GridSummary summary,
                 FileContents& contents);

/// Adds a lattice like add_lattice, but without examining its heights, which the caller has done.
void add_checked_lattice(const InputFile& file, std::string name, const NodeLattice& lattice, GridSummary summary,
                         FileContents& contents);

}  // namespace geomesh::geomodel
