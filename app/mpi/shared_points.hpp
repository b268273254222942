// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines which ranks have what at a place: all ranks send their places to the rank that keeps the place, which
/// answers.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh_faces.hpp"
#include "ranks.hpp"

namespace geomesh::app {

/// For each place, the ranks that have a point there, ascending.
using Sharers = ByPlace<std::vector<std::int32_t>>;
/// Finds which ranks share this rank's points `rows`, which must include all that others may have too. O(n) in these,
/// and messages of that length.
Sharers find_sharers(const RankMesh& mesh, const std::vector<VertexIndex>& rows, const Ranks& ranks);

/// The cell across an open face of this rank; `rank` is -1 if there is none.
struct Across {
  std::int32_t rank = -1;
  Index component = no_index;
};
/// Returns the result for each open face. Faces are matched by the coordinates of their corners, bit by bit. Throws
/// InternalError if three tetrahedra have the same face, or two lie on the same side of it.
std::vector<Across> match_faces(const RankMesh& mesh, const std::vector<OpenFace>& faces, const Ranks& ranks);

}  // namespace geomesh::app
