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
/// between blocks. The blocks do not depend on the threads, and so neither does the result. Ends early where
/// `out_of_time` says so, which is asked now and then, by one thread at a time. O(n log n).
void smooth_all(Toolbox& tools, const SmoothRule& rule, unsigned threads, const std::function<bool()>& out_of_time);

/// By vertex: the mesh's time when all flips about it were in vain. Empty before the first pass.
using FlipsInVain = std::vector<std::uint64_t>;

/// One pass of flips, edges in the inside alone, and one of moves that raise the mean worth of shapes (MeanGoal); none
/// falls below `floor` and what was worst about the place. Worst-first repair leaves what is merely mediocre alone.
/// Flips that were in vain in a pass before are tried again only where something has changed since.
void raise_mean(Toolbox& tools, double floor, unsigned smoothing_steps, const RunContext& context,
                FlipsInVain& in_vain);

/// Runs the schedule of the level. Cooperative with the time budget and the cancel token. What the judge finds in the
/// end, where given, is worth a longer search.
void improve_mesh(Toolbox& tools, const RefineOptions& options, const RunContext& context,
                  const FreeCellJudge* judge = nullptr);

}  // namespace geomesh::remesh
