// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Improves the borders between ranks after shifting the partition past them.
#pragma once

#include "part.hpp"
#include "ranks.hpp"

namespace geomesh::app {

struct StripsResult {
  std::size_t n_tetrahedra = 0;  ///< number of tetrahedra that this rank has improved again
  std::size_t n_never_free = 0;  ///< number of points, over all ranks, that were between ranks in every round
};

/// Sends tetrahedra within some layers of a border to one of the ranks that share it, where they are improved: the
/// former border is then inside, and the strip's own border is kept. A second round handles what lay on borders in the
/// first round too. Afterwards the partition is the shifted one.
StripsResult improve_strips(RankMesh& mesh, const RankModel& model, const RefineOptions& options, const Ranks& ranks,
                            const RunContext& context);

}  // namespace geomesh::app
