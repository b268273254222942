// SPDX-License-Identifier: MIT
/// @file
/// What the removal of added points is made of; added_points.cpp puts it together.
#pragma once

#include <vector>

#include "recover/model/recover.hpp"

namespace geomesh::recover {

inline VertexIndex first_added(const Recovery& recovery) {
  return static_cast<VertexIndex>(recovery.mesh.n_input() + 8);
}
/// On a segment or facet.
inline bool is_on_boundary(const Recovery& recovery, VertexIndex x) {
  return recovery.mesh.in_mesh(x) && recovery.constraints.vertices[x].origin != VertexOrigin::inside;
}

/// The neighbours of x on its segment: two where x is not the end of a hanging one.
std::vector<VertexIndex> segment_neighbors(Recovery& recovery, VertexIndex x);

/// Removes edges at x that may go. True where any went.
bool lower_degree(Recovery& recovery, VertexIndex x);

/// Takes x off a segment round which a region goes all the way, at the price of points in the region: up to five beside
/// x are the apexes of sheets that part it. False: nothing has changed.
bool take_off_with_sheets(Recovery& recovery, VertexIndex x);

/// Removes added points that no constraint holds where their star, or a region about it, can be filled without them.
void remove_inner_points(Recovery& recovery, InnerEffort effort);

/// Per cell, 1 where no locked face parts it from the box: what is there is left out in the end.
std::vector<std::uint8_t> cells_outside(const ConstrainedMesh& mesh);

}  // namespace geomesh::recover
