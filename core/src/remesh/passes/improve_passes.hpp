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
/// blocks. The result does not depend on the number of threads. Ends early if `out_of_time`, which one thread at a time
/// calls now and then, returns true. `leaves(v)` returns whether v must not move. O(n log n).
void smooth_all(Toolbox& tools, const SmoothRule& rule, unsigned threads, const std::function<bool()>& out_of_time,
                const std::function<bool(VertexIndex)>& leaves = {});

/// Raises the mean worth of all shapes (MeanGoal) by one pass of flips at inner edges and one of moves. No shape falls
/// below both `floor` and the worst shape around. This improves mediocre cells, which worst-first repair leaves alone.
/// Only vertices with a cell below `poor` are visited.
void raise_mean(Toolbox& tools, double floor, unsigned smoothing_steps, const RunContext& context, double poor = 1);

/// Moves vertices of surfaces along the normal, so that as much volume lies between faces and input on one side as on
/// the other. (If all vertices lie on a convex surface, all faces are on its inside.) First, vertices of free borders
/// (edges with one face) move across the border, so that each surface encloses the area of its input. Surfaces remain
/// within the tolerance, and the worst shape of the mesh does not fall. Does nothing where surfaces are kept. On all
/// cores, with the same result whatever their number. O(n) and a search for each sample.
void balance_surfaces(Toolbox& tools, const RunContext& context);

/// Runs the schedule of improvement for the quality level, within the time budget and until cancelled. If `judge` is
/// given, the bad cells that it finds at the end get a longer search.
void improve_mesh(Toolbox& tools, const RefineOptions& options, const RunContext& context,
                  const FreeCellJudge* judge = nullptr);

/// Runs the last part of the schedule of improvement again: repairs bad cells that have appeared since, by sequences of
/// operations, and removes points that are too close to others.
void mend_bad_cells(Toolbox& tools, const RefineOptions& options, const RunContext& context);

}  // namespace geomesh::remesh
