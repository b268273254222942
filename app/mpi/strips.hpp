// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The borders between ranks, improved once the partition has been shifted past them.
#pragma once

#include "part.hpp"
#include "ranks.hpp"

namespace geomesh::app {

struct StripsResult {
  std::size_t n_tetrahedra = 0;  ///< that this rank has improved again
  std::size_t n_never_free = 0;  ///< points of all ranks that were between ranks in every round
};

/// Tetrahedra within some layers of a border go to one of the ranks that share it, and are improved there: what was the
/// border lies inside now, and the strip's own border stays. A second round takes what lay on borders in the first
/// too. Afterwards the partition is the shifted one.
StripsResult improve_strips(RankMesh& mesh, const RankModel& model, const RefineOptions& options, const Ranks& ranks,
                            const RunContext& context);

}  // namespace geomesh::app
