// SPDX-License-Identifier: MIT
/// @file
/// Repair that looks ahead: sequences of operations around a bad cell, each kept only if the whole sequence is worth
/// it.
#pragma once

#include "remesh/operations/operations.hpp"
#include "remesh/rescue/bad_cells.hpp"
#include "remesh/rescue/openings.hpp"

namespace geomesh::remesh {

struct RescueRule {
  double bad_shape;          ///< a cell with a lower shape is bad
  unsigned smoothing_steps;  ///< largest number of steps when a vertex is moved
  unsigned max_steps;        ///< largest number of operations in a sequence
};

using OutOfTime = std::function<bool()>;

/// Number of sequences that may still fail, over all cells. Sequences around a cell that is improved in the end do not
/// count. So if bad cells are few, all are tried, and if the input imposes very many, the work is bounded.
struct VainTrials {
  std::size_t left;
};
/// Returns the budget for a mesh of n_cells cells, at most `most`.
VainTrials vain_trials(std::size_t n_cells, std::size_t most);

/// Improves the bad cell c and every cell that becomes bad by that. Each operation raises the worst shape around it,
/// while the number of bad cells may rise. The result is kept if there are fewer bad cells in the end, or as many and
/// the worst of them is notably better; otherwise everything is restored. Returns whether it was kept.
bool rescue_cell(Toolbox& tools, CellIndex c, const RescueRule& rule);

/// For cells that rescue_cell does not improve: sequences that begin with an operation which may make the place worse.
/// An edge of the cell is split, a point is put into it or a cell beside it, or one of its vertices or of those around
/// it is removed. The first sequence that is worth it is kept. Many times as expensive as rescue_cell.
bool rescue_cell_by_openings(Toolbox& tools, CellIndex c, const RescueRule& rule, VainTrials& vain);

/// Moves u into its neighbour v, whatever the cost for the cells around it, and repairs those by flips, moves and
/// further collapses, without new points. Kept if no more cells are bad than before, their sum is no worse, and the
/// worst of them is no worse.
bool collapse_mending(Toolbox& tools, VertexIndex u, VertexIndex v, const RescueRule& rule);

/// Moves u away from v until they are far enough apart. The repair may bring them nearer again.
bool stretch_mending(Toolbox& tools, VertexIndex u, VertexIndex v, double length, const RescueRule& rule);

/// State that consecutive searches share.
struct RescueSearch {
  Random choose;
  std::size_t trials_a_cell;
  std::size_t trials_left;  ///< number of failures left in total
  OutOfTime out_of_time;
  const FreeCellJudge& judge;
};

/// For cells that rescue_cell_openly does not improve either: trials of up to RescueLimits::most_openings openings.
/// Each opening is chosen at random around the worst cell that the repair of the previous one has left. A trial that
/// leaves any cell worse than the worst was is not kept. The first other trial is kept that leaves fewer bad cells, or
/// as many that together lack notably less. (Beside a cell that cannot be improved, the worst shape says nothing.) A
/// trial is also kept if it leaves only bad cells imposed by the input, and at most one more of them. If such a cell
/// has only been replaced by another, and the place is hardly worse, the search continues from there. Returns whether
/// the cell is improved. A trial costs about a millisecond.
bool rescue_cell_by_search(Toolbox& tools, CellIndex c, const RescueRule& rule, RescueSearch& search);

/// Rescues all bad cells of the mesh, and repeats that where something has changed since.
void rescue_bad_cells(Toolbox& tools, const RescueRule& rule, const OutOfTime& out_of_time);

/// Rescues the worst cells of all: with openings if sequences without them fail. It ends when `most_vain` sequences of
/// a kind have failed, or fewer in a small mesh: then the input imposes what is left.
void rescue_flat_cells(Toolbox& tools, const RescueRule& rule, std::size_t most_vain, const OutOfTime& out_of_time);

/// Rescues bad cells that the input does not impose, which are worth more effort: with openings, and a search among
/// these. More sequences may fail than for cells imposed by the input.
void rescue_free_cells(Toolbox& tools, const RescueRule& rule, const FreeCellJudge& judge,
                       const OutOfTime& out_of_time);

}  // namespace geomesh::remesh
