// SPDX-License-Identifier: MIT
/// @file
/// The passes of improvement over the whole mesh, and the schedule that runs them.
#pragma once

#include <functional>
#include <span>

#include "geomesh/core/run_context.hpp"
#include "remesh/operations/improve.hpp"
#include "remesh/rescue/bad_cells.hpp"

namespace geomesh::remesh {

/// Smooths all vertices that may move, on as many threads as given (0: all cores): block by block, then what lies
/// between blocks. The blocks do not depend on the threads, so neither does the result. Ends early if `out_of_time`
/// returns true, which is called now and then by one thread at a time. Returns, by vertex, how much its move raised the
/// sum of worths (0: not moved, or the sum is not the goal). `leaves(v)` returns which vertices must not move. O(n log
/// n).
std::vector<double> smooth_all(Toolbox& tools, const SmoothRule& rule, unsigned threads,
                               const std::function<bool()>& out_of_time,
                               const std::function<bool(VertexIndex)>& leaves = {});

/// State that a pass that raises the mean leaves to the next: the places worth examining again.
struct RaisedBefore {
  std::vector<double> gains;  ///< by vertex, of its move. Empty before the first pass
  std::uint64_t end = 0;      ///< the mesh's time then
  double much_gained = 3;     ///< of the least gain that is worth a move: what gained more is looked at again
};

/// One pass of flips, edges in the inside alone, and one of moves that raise the mean worth of shapes (MeanGoal); none
/// falls below `floor` and what was worst about the place. Worst-first repair leaves what is merely mediocre alone.
/// After the first pass only those vertices are looked at that have a cell below `poor` about them. Something else must
/// have changed about them since, or they share a cell with one whose last move gained much.
void raise_mean(Toolbox& tools, double floor, unsigned smoothing_steps, const RunContext& context, RaisedBefore& before,
                double poor = 1);

/// Moves vertices of surfaces along the normal, so that as much volume lies between faces and input on one side as on
/// the other. Vertices that lie on a convex surface have all faces on its inside. Before that, vertices of free borders
/// (edges with one face) move across the border, so that each surface encloses the area of its input. Surfaces remain
/// within the tolerance, and the worst shape of the mesh does not fall. Does nothing where surfaces are kept. On all
/// cores, with the same result whatever their number. O(n) and a search for each sample.
void balance_surfaces(Toolbox& tools, const RunContext& context);

/// Runs the schedule of the level. Cooperates with the time budget and the cancel token. Cells that `judge` finds in
/// the end, if given, are worth a longer search.
void improve_mesh(Toolbox& tools, const RefineOptions& options, const RunContext& context,
                  const FreeCellJudge* judge = nullptr);

}  // namespace geomesh::remesh
