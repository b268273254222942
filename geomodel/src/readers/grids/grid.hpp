// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Grids of heights as files hold them, and how they become surfaces with holes.
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/surface.hpp"
#include "readers/text/input_file.hpp"
#include "readers/text/text.hpp"

namespace geomesh::geomodel {

/// Heights at nodes in columns and rows. Of files whose values belong to cells (rasters) the nodes are the cells'
/// centres.
struct Grid {
  std::string name;
  std::size_t n_columns = 0, n_rows = 0;
  double x0 = 0, y0 = 0;  ///< the node of column 0, row 0: the south-west one where rotation is 0
  double dx = 0, dy = 0;  ///< between nodes, positive
  double rotation = 0;    ///< of the columns' direction from east, degrees counter-clockwise about (x0, y0)
  bool cell_centred = false;
  std::vector<double> heights;  ///< row * n_columns + column; NaN where there is none

  double& at(std::size_t column, std::size_t row) { return heights[row * n_columns + column]; }
};

/// Nodes of any position in columns and rows.
struct NodeLattice {
  std::size_t n_columns = 0, n_rows = 0;
  std::vector<Vec3> nodes;  ///< row * n_columns + column; z NaN where there is none
};

/// Checks the counts of a header against what follows (`bytes_left` bytes of at least `least_bytes` a value) before
/// heights are allocated; all become NaN. Throws Error{invalid_input} where there are fewer than two columns or rows,
/// or more than can follow.
void allocate_heights(const InputFile& file, Grid& grid, std::size_t bytes_left, std::size_t least_bytes);

/// Throws Error{invalid_input} where the limits along `axis` ("x", "y") are equal or the wrong way round; the spacing
/// of n nodes.
double node_spacing(const InputFile& file, const char* axis, double low, double high, std::size_t n);

/// The next height of a text grid; NaN where the token says so or is infinite, an error where it is no number.
double read_height(TokenStream& tokens);
/// Throws Error{invalid_input} where anything follows the last value.
void expect_end_of_grid(TokenStream& tokens, const Grid& grid);
/// All heights of a text grid in the file's order, and its end; nodes with a value of `limit` or more have none.
void read_heights_below(double limit, TokenStream& tokens, Grid& grid);

/// How a cell of four nodes is split.
enum class Diagonal {
  of_less_relief,  ///< along the smaller height difference: follows ridges and valleys
  from_first,      ///< from its first node to the opposite one
};

/// Two triangles a cell of four nodes; one where one node is missing; none else. Normals point up. Nodes that belong to
/// no triangle are left out and counted.
TriangulatedSurface triangulate_lattice(const NodeLattice& lattice, Diagonal diagonal, std::size_t& n_left_out);

/// The grid as the one surface of its file, with notes on what was understood. Throws Error{invalid_input} where no
/// cell is complete.
FileContents grid_contents(const InputFile& file, std::string format, const Grid& grid);

/// Appends a lattice as a surface; `summary` is completed with its counts. Heights that stand for "no value" though no
/// header says so are left out with a warning (readers/text/no_data.hpp). Errors as above.
void add_lattice(const InputFile& file, std::string name, NodeLattice lattice, GridSummary summary,
                 FileContents& contents);

/// Adds a lattice like add_lattice, without looking through its heights: the caller has done that.
void add_checked_lattice(const InputFile& file, std::string name, const NodeLattice& lattice, GridSummary summary,
                         FileContents& contents);

}  // namespace geomesh::geomodel
