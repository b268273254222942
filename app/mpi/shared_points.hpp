// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Which ranks have what at a place: rank by rank told to the one that keeps this place, and back.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh_faces.hpp"
#include "ranks.hpp"

namespace geomesh::app {

/// By place: the ranks that have a point there, ascending.
using Sharers = ByPlace<std::vector<std::int32_t>>;
/// Of this rank's points `rows`, which are all that others may have too. O(n) in these, and the messages as long.
Sharers find_sharers(const RankMesh& mesh, const std::vector<VertexIndex>& rows, const Ranks& ranks);

/// What lies across open faces of this rank: `rank` -1 where there is nothing.
struct Across {
  std::int32_t rank = -1;
  Index component = no_index;
};
/// By open face. Faces are matched by the places of their corners, bit by bit. Throws InternalError where three
/// tetrahedra have one, or two lie on the same side of it.
std::vector<Across> match_faces(const RankMesh& mesh, const std::vector<OpenFace>& faces, const Ranks& ranks);

}  // namespace geomesh::app
