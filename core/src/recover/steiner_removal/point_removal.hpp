// SPDX-License-Identifier: MIT
/// @file
/// Single operations for the removal of Steiner points, which added_points.cpp combines.
#pragma once

#include <vector>

#include "recover/model/recover.hpp"

namespace geomesh::recover {

inline VertexIndex first_added(const Recovery& recovery) {
  return static_cast<VertexIndex>(recovery.mesh.n_input() + 8);
}
/// Returns whether x is on a segment or facet.
inline bool is_on_boundary(const Recovery& recovery, VertexIndex x) {
  return recovery.mesh.in_mesh(x) && recovery.constraints.vertices[x].origin != VertexOrigin::inside;
}

/// Returns the neighbours of x along its segment: two, unless the segment ends at x.
std::vector<VertexIndex> segment_neighbors(Recovery& recovery, VertexIndex x);

/// Reduces the number of mesh edges at vertex x by flips. Returns whether any edge was removed.
bool lower_degree(Recovery& recovery, VertexIndex x);

/// Removes x from a segment that a region surrounds, at the cost of points in the region: up to five points beside x
/// become the apexes of triangles (sheets) that divide the region. Returns false if nothing has changed.
bool take_off_with_sheets(Recovery& recovery, VertexIndex x);

/// Removes added points that are on no constraint if their star, or a region around it, can be filled without them.
void remove_inner_points(Recovery& recovery, InnerEffort effort);

/// Returns for each cell 1 if no locked face separates it from the box, which means that it is outside the model.
std::vector<std::uint8_t> cells_outside(const ConstrainedMesh& mesh);

}  // namespace geomesh::recover
