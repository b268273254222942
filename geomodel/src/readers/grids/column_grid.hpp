// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Shared by ZMAP+ and CPS-3: values at nodes, column by column from the west, each from the north.
#pragma once

#include "readers/grids/grid.hpp"

namespace geomesh::geomodel {

/// The position of the next value in such a file.
class ColumnMajorFill {
 public:
  explicit ColumnMajorFill(Grid& grid) : grid_(grid) {}
  bool full() const { return n_ == grid_.heights.size(); }
  /// NaN leaves the node without a value. Precondition: not full.
  void add(double value) {
    grid_.at(n_ / grid_.n_rows, grid_.n_rows - 1 - n_ % grid_.n_rows) = value;
    ++n_;
  }
  std::size_t count() const { return n_; }

 private:
  Grid& grid_;
  std::size_t n_ = 0;
};

/// Null values are written with fewer digits than a double has: 0.1E+31 as 1.0000000E+30.
bool is_null(double value, double null);

}  // namespace geomesh::geomodel
