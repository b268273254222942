// SPDX-License-Identifier: MIT
/// @file
/// A search among sequences of operations, for cells about which those of rescue.hpp were in vain.
#pragma once

#include "remesh/rescue/free_cell_judge.hpp"
#include "remesh/rescue/openings.hpp"
#include "remesh/rescue/rescue.hpp"

namespace geomesh::remesh {

/// What searches share, one after the other.
struct RescueSearch {
  Chooser choose;
  std::size_t trials_a_cell;
  std::size_t trials_left;  ///< of all together
  std::function<bool()> out_of_time;
  const FreeCellJudge& judge;
};

/// The same where that was in vain, by trials of up to RescueLimits::most_openings openings. Each is chosen at random
/// about the worst cell that the repair of the one before has left. A trial that leaves any cell worse than the worst
/// was is not kept. The first other trial is kept that leaves fewer bad cells, or as many that together lack notably
/// less. (Beside a cell that cannot be mended the worst alone tells nothing.) So is one that leaves no cell that
/// nothing forces and one bad cell more at most. Where such a cell has only made way for another and the place is
/// hardly worse, the search goes on from there. Returns whether the cell is mended. A trial costs about a millisecond.
bool rescue_cell_by_search(Toolbox& tools, CellIndex c, const RescueRule& rule, RescueSearch& search);

}  // namespace geomesh::remesh
