// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Loops over the cells of a solver file in the order of their labels, the numbers of their region, surface or curve.
#pragma once

#include <span>

#include "solver_mesh/solver_mesh.hpp"

namespace geomesh::geomodel {

/// Calls `visit(label, block, cell, nodes)` for every cell of one dimension, sorted by label: the number in the file of
/// the cell's region, surface or curve. `nodes` are rows of the mesh, in VTK's order.
template <class Visit>
void for_each_cell(const SolverMesh& mesh, int dimension, Visit&& visit) {
  for (const CellGroup& label : mesh.labels) {
    if (label.dimension != dimension) continue;
    for (const std::size_t b : label.blocks) {
      const CellBlock& block = mesh.blocks[b];
      for (std::size_t c = 0; c < block.n_cells(); ++c)
        visit(label, block, c,
              std::span<const VertexIndex>(block.nodes).subspan(c * block.nodes_per_cell, block.nodes_per_cell));
    }
  }
}

/// Returns write options that give each cell exactly one number: a face on several surfaces gets a number of its own.
inline WriteOptions with_one_number(WriteOptions options) {
  if (options.groups == GroupChoice::both) options.groups = GroupChoice::whole;
  return options;
}

}  // namespace geomesh::geomodel
