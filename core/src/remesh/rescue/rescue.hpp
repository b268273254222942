// SPDX-License-Identifier: MIT
/// @file
/// Repair that looks ahead: sequences of operations around a bad cell, kept only if the cells are better as a whole.
#pragma once

#include "remesh/operations/operations.hpp"
#include "remesh/rescue/bad_cells.hpp"
#include "remesh/rescue/openings.hpp"

namespace geomesh::remesh {

struct RescueRule {
  double bad_shape;          ///< a cell with a lower shape is bad
  unsigned smoothing_steps;  ///< largest number of steps when a vertex is moved
  unsigned max_steps;        ///< largest number of operations in one sequence that repairs a bad cell
};

using OutOfTime = std::function<bool()>;

/// Number of sequences of repair that may still fail, over all cells. Sequences around a cell that is improved in the
/// end do not count. Therefore all bad cells are tried if they are few, and the work is bounded if the input imposes
/// many.
struct VainTrials {
  std::size_t left;
};
/// Returns how many sequences of repair may fail in a mesh of n_cells cells: in proportion, but at most `most`.
VainTrials vain_trials(std::size_t n_cells, std::size_t most);

/// Improves the bad cell c and every cell that becomes bad by this. Each operation raises the worst shape around it,
/// while the number of bad cells may rise. The result is kept if there are fewer bad cells in the end, or as many and
/// the worst of them is notably better; otherwise everything is restored. Returns whether the result was kept.
bool rescue_cell(Toolbox& tools, CellIndex c, const RescueRule& rule);

/// Improves a cell that rescue_cell does not improve, by sequences that begin with an opening, an operation which may
/// worsen the shapes around. An opening splits an edge of the cell, inserts a point into it or a cell beside it, or
/// removes one of its vertices or of those around. The first sequence that improves the cells as a whole is kept. Many
/// times as expensive as rescue_cell.
bool rescue_cell_by_openings(Toolbox& tools, CellIndex c, const RescueRule& rule, VainTrials& vain);

/// Contracts the edge u-v by moving u to v, whatever the cost for the cells around, and repairs these by flips, moves
/// and further contractions, without new points. The result is kept if there are no more bad cells than before, and
/// neither the sum of what their shapes lack nor the worst of them is worse. Returns whether it was kept.
bool collapse_mending(Toolbox& tools, VertexIndex u, VertexIndex v, const RescueRule& rule);

/// Moves u away from its neighbour v until they are `length` apart, and repairs the cells around without new points,
/// which may move u closer again. The result is kept only if bad cells are no more and no worse than before.
bool stretch_mending(Toolbox& tools, VertexIndex u, VertexIndex v, double length, const RescueRule& rule);

/// State shared by consecutive calls of rescue_cell_by_search, which tries random sequences of operations.
struct RescueSearch {
  Random choose;
  std::size_t trials_a_cell;
  std::size_t trials_left;  ///< number of trials left, over all bad cells
  OutOfTime out_of_time;
  const FreeCellJudge& judge;
};

/// Improves a cell that rescue_cell_by_openings does not improve either, by trials of up to RescueLimits::most_openings
/// openings. Each opening is chosen at random around the worst cell that the repair of the previous one has left. A
/// trial that leaves any cell worse than the worst before is not kept. The first of the other trials is kept that
/// leaves fewer bad cells, or as many that together lack notably less. (Next to a cell that cannot be improved, the
/// worst shape says nothing.) A trial is also kept if it leaves only bad cells imposed by the input, and at most one
/// more of these. If a bad cell that the input does not impose has only been replaced by another, and the shapes are
/// hardly worse, the search continues from the new one. Returns whether the cell is improved. A trial takes about 1 ms.
bool rescue_cell_by_search(Toolbox& tools, CellIndex c, const RescueRule& rule, RescueSearch& search);

/// Calls rescue_cell for all bad cells of the mesh, and again for those around which something has changed since.
void rescue_bad_cells(Toolbox& tools, const RescueRule& rule, const OutOfTime& out_of_time);

/// Improves the worst cells of the mesh, with openings if sequences without them fail. Ends when `most_vain` sequences
/// of a kind have failed, or fewer in a small mesh, because the input then imposes the remaining cells.
void rescue_flat_cells(Toolbox& tools, const RescueRule& rule, std::size_t most_vain, const OutOfTime& out_of_time);

/// Improves bad cells that the input does not impose: by repair alone, after an opening, or by random search. More
/// sequences of operations may fail than for bad cells that the input imposes.
void rescue_free_cells(Toolbox& tools, const RescueRule& rule, const FreeCellJudge& judge,
                       const OutOfTime& out_of_time);

}  // namespace geomesh::remesh
