// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Improves tetrahedra at the borders between ranks, after moving these borders elsewhere.
#pragma once

#include "part.hpp"
#include "ranks.hpp"

namespace geomesh::app {

struct StripsResult {
  std::size_t n_tetrahedra = 0;  ///< number of tetrahedra that this rank has improved again
  std::size_t n_never_free =
      0;  ///< number of points, over all ranks, that were on a border between ranks in every round
};

/// Sends the strip of tetrahedra within some layers of a border to one of the ranks that share the border, which
/// improves them. The former border is then inside the strip, and only the strip's own border is kept. A second round
/// handles points that were on borders in the first round, too. Tetrahedra remain on the ranks that have improved them.
StripsResult improve_strips(RankMesh& mesh, const RankModel& model, const RefineOptions& options, const Ranks& ranks,
                            const RunContext& context);

}  // namespace geomesh::app
