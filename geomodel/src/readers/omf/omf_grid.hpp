// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Grid surfaces of OMF version 1.
#pragma once

#include <optional>
#include <vector>

#include "readers/grids/grid.hpp"

namespace geomesh::geomodel {

/// An OMF grid as in the file: cells along two axes, with each node displaced along the cross product of the axes.
struct OmfGrid {
  Vec3 origin, axis_u, axis_v;
  std::vector<double> cells_u, cells_v;  ///< widths
  std::vector<double> offsets;           ///< displacement of each node of the OMF grid; empty if the grid is flat
  std::size_t n_columns() const { return cells_u.size() + 1; }
  std::size_t n_rows() const { return cells_v.size() + 1; }
};

/// Returns the nodes of an OMF grid, with columns along u. The format does not say whether the nodes of `offsets` are
/// ordered along u or along v first, and writers differ. The order that makes the surface clearly smoother is chosen:
/// the sum of squared differences between neighbours must be at most half of that for the other order. Returns nothing
/// if neither order is. Precondition: there are as many offsets as nodes, or none.
std::optional<NodeLattice> nodes_of(const OmfGrid& grid);

}  // namespace geomesh::geomodel
