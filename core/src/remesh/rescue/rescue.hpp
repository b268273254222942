// SPDX-License-Identifier: MIT
/// @file
/// Repair that looks ahead: sequences of operations about a bad cell, each kept only where the whole of it is worth it.
#pragma once

#include <limits>

#include "remesh/operations/operations.hpp"
#include "remesh/rescue/bad_cells.hpp"
#include "remesh/rescue/openings.hpp"

namespace geomesh::remesh {

struct RescueRule {
  double bad_shape;          ///< below this a cell is bad
  unsigned smoothing_steps;  ///< of a vertex that moves
  unsigned max_steps;        ///< operations of one sequence
};

using OutOfTime = std::function<bool()>;

/// How many sequences may still be tried in vain, of all cells together. Those about a cell that is mended in the end
/// cost nothing. So where bad cells are few all are tried, and where the input forces very many the work is bounded.
struct VainTrials {
  std::size_t left;
};
/// For a mesh of so many cells; no more than `most`.
VainTrials vain_trials(std::size_t n_cells, std::size_t most);

/// Mends the bad cell c and whatever becomes bad by that. Each operation raises the worst shape about it, while the
/// number of bad cells may rise. Kept where in the end there are fewer bad cells than before, or as many and the worst
/// of them is notably better; else everything is as it was. Returns whether it was kept.
bool rescue_cell(Toolbox& tools, CellIndex c, const RescueRule& rule);

/// The same where that was in vain, with sequences that open with an operation which may make the place worse: an edge
/// of the cell split, a point put into it or a cell beside it; one of its vertices or of those about it removed. The
/// first that is worth it is kept. Many times as dear as rescue_cell.
bool rescue_cell_by_openings(Toolbox& tools, CellIndex c, const RescueRule& rule, VainTrials& vain);

/// Moves u into its neighbour v, at whatever cost for the cells about it. Mends those by flips, moves and more of that,
/// without new points. Kept where no more cells are bad than before, they lack no more together, and the worst of them
/// is no worse.
bool collapse_mending(Toolbox& tools, VertexIndex u, VertexIndex v, const RescueRule& rule);

/// The same for a move of u away from v, until they are so far apart. What is mended then may bring them nearer again.
bool stretch_mending(Toolbox& tools, VertexIndex u, VertexIndex v, double length, const RescueRule& rule);

/// What searches share, one after the other.
struct RescueSearch {
  Random choose;
  std::size_t trials_a_cell;
  std::size_t trials_left;  ///< of all together
  OutOfTime out_of_time;
  const FreeCellJudge& judge;
};

/// The same where that was in vain, by trials of up to RescueLimits::most_openings openings. Each is chosen at random
/// about the worst cell that the repair of the one before has left. A trial that leaves any cell worse than the worst
/// was is not kept. The first other trial is kept that leaves fewer bad cells, or as many that together lack notably
/// less. (Beside a cell that cannot be mended the worst alone tells nothing.) So is one that leaves no cell that
/// nothing forces and one bad cell more at most. Where such a cell has only made way for another and the place is
/// hardly worse, the search goes on from there. Returns whether the cell is mended. A trial costs about a millisecond.
bool rescue_cell_by_search(Toolbox& tools, CellIndex c, const RescueRule& rule, RescueSearch& search);

/// Rescues over all bad cells of the mesh, again where something has changed since.
void rescue_bad_cells(Toolbox& tools, const RescueRule& rule, const OutOfTime& out_of_time);

/// How much is done at most.
struct RescueWork {
  std::size_t most_vain;  ///< sequences in vain
  std::size_t most_cells = std::numeric_limits<std::size_t>::max();
};

/// The same for the worst there are: with openings where that is in vain, as long as few are in vain.
void rescue_flat_cells(Toolbox& tools, const RescueRule& rule, RescueWork work, const OutOfTime& out_of_time);

/// What is bad by our own doing, and not by the input's, is worth more: with openings, and a search among these.
/// More sequences in vain are allowed than about forced ones.
void rescue_free_cells(Toolbox& tools, const RescueRule& rule, const FreeCellJudge& judge,
                       const OutOfTime& out_of_time);

}  // namespace geomesh::remesh
