// SPDX-License-Identifier: MIT
/// @file
/// Repair that looks ahead: a sequence of operations about a bad cell, kept only where the whole of it is worth it.
#pragma once

#include "remesh/operations/operations.hpp"

namespace geomesh::remesh {

struct RescueRule {
  double bad_shape;          ///< below this a cell is bad
  unsigned smoothing_steps;  ///< of a vertex that moves
  unsigned max_steps;        ///< operations of one sequence
};

/// Mends the bad cell c and whatever becomes bad by that. Each operation raises the worst shape about it, while the
/// number of bad cells may rise. Kept where in the end there are fewer bad cells than before, or as many and the worst
/// of them is notably better; else everything is as it was. Returns whether it was kept.
bool rescue_cell(Toolbox& tools, CellIndex c, const RescueRule& rule);

/// The same where that was in vain, with sequences that open with an operation which may make the place worse: an edge
/// of the cell split, a point put into it or a cell beside it; one of its vertices or of those about it removed. The
/// first that is worth it is kept. Many times as dear as rescue_cell.
bool rescue_cell_by_openings(Toolbox& tools, CellIndex c, const RescueRule& rule);

}  // namespace geomesh::remesh
