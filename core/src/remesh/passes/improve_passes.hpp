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

/// Smooths all vertices that may move, on the given number of threads (0: all cores), block by block and then between
/// blocks. The result does not depend on the number of threads. It ends early if `out_of_time`, which one thread at a
/// time calls now and then, returns true. `leaves(v)` returns whether v must not move. O(n log n).
void smooth_all(Toolbox& tools, const SmoothRule& rule, unsigned threads, const std::function<bool()>& out_of_time,
                const std::function<bool(VertexIndex)>& leaves = {});

/// One pass of flips at inner edges and one of moves, which both raise the mean worth of shapes (MeanGoal); no shape
/// falls below both `floor` and the worst one there. Worst-first repair does not improve mediocre cells. Only vertices
/// with a cell below `poor` are visited.
void raise_mean(Toolbox& tools, double floor, unsigned smoothing_steps, const RunContext& context, double poor = 1);

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

/// Runs the last part of the schedule again: repairs bad cells that were made since by sequences of operations, and
/// removes points that are too near to others.
void mend_bad_cells(Toolbox& tools, const RefineOptions& options, const RunContext& context);

}  // namespace geomesh::remesh
