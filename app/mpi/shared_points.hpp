// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines which ranks have a point or a face at the same coordinates. One rank is responsible for each point or
/// face: all ranks send theirs to the responsible ranks, which answer who shares it.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh_faces.hpp"
#include "ranks.hpp"

namespace geomesh::app {

/// For each place of a point, the ranks that have a point there, in ascending order.
using Sharers = ByPlace<std::vector<std::int32_t>>;
/// Finds out which ranks share the points `rows` of this rank, which must include all points that other ranks may have,
/// too. O(n) time and length of messages for n points.
Sharers find_sharers(const RankMesh& mesh, const std::vector<VertexIndex>& rows, const Ranks& ranks);

/// The cell on another rank across an open face of this rank; `rank` is -1 if there is none.
struct Across {
  std::int32_t rank = -1;
  Index component = no_index;
};
/// Finds the cell on another rank across each open face. Faces are matched by the coordinates of their corners, bit by
/// bit. Throws InternalError if three tetrahedra have the same face, or two lie on the same side of it.
std::vector<Across> match_faces(const RankMesh& mesh, const std::vector<OpenFace>& faces, const Ranks& ranks);

}  // namespace geomesh::app
