// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Fills grids of the formats ZMAP+ and CPS-3, whose values are ordered column by column from the west, each column
/// from the north.
#pragma once

#include "readers/grids/grid.hpp"

namespace geomesh::geomodel {

/// Writes the values of a grid file with columns from north to south into a grid, one after the other.
class ColumnMajorFill {
 public:
  explicit ColumnMajorFill(Grid& grid) : grid_(grid) {}
  bool full() const { return n_ == grid_.heights.size(); }
  /// Sets the height of the next grid node. NaN leaves it without a value. Precondition: not all nodes have been set.
  void add(double value) {
    grid_.at(n_ / grid_.n_rows, grid_.n_rows - 1 - n_ % grid_.n_rows) = value;
    ++n_;
  }
  std::size_t count() const { return n_; }

 private:
  Grid& grid_;
  std::size_t n_ = 0;
};

/// Returns whether a value is the grid file's null value, which has fewer digits than a double: 0.1E+31 as
/// 1.0000000E+30.
bool is_null(double value, double null);

}  // namespace geomesh::geomodel
