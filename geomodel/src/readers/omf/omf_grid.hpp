// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Grid surfaces of OMF version 1.
#pragma once

#include <optional>
#include <vector>

#include "readers/grids/grid.hpp"

namespace geomesh::geomodel {

/// As the file gives it: cells along two axes, each node moved along their cross product.
struct OmfGrid {
  Vec3 origin, axis_u, axis_v;
  std::vector<double> cells_u, cells_v;  ///< widths
  std::vector<double> offsets;           ///< one a node, or none: flat
  std::size_t n_columns() const { return cells_u.size() + 1; }
  std::size_t n_rows() const { return cells_v.size() + 1; }
};

/// The nodes, columns along u. The format does not say whether the nodes of `offsets` run along u or along v first, and
/// its writers do not agree. The order is taken in which the surface is clearly smoother: half of the squared
/// differences between neighbours, or less. Nothing where neither is. Precondition: offsets are as many as nodes, or
/// none.
std::optional<NodeLattice> nodes_of(const OmfGrid& grid);

}  // namespace geomesh::geomodel
