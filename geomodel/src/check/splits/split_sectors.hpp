// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Counts the sectors of tetrahedra around the points of split surfaces.
#pragma once

#include <set>
#include <vector>

#include "check/mesh/checked_mesh.hpp"

namespace geomesh::geomodel::checking {

/// Tetrahedra by places.
struct JoinedCells {
  std::size_t n_points;
  const std::vector<Tetrahedron>& tetrahedra;
};

/// Returns the merged points that do not have exactly one node for each sector, ascending. A sector is a set of
/// tetrahedra around a point that are connected through faces which are not split. `nodes` are the same tetrahedra,
/// corner by corner, with the nodes of the file. O(n log n).
std::vector<VertexIndex> nodes_unlike_sectors(const JoinedCells& joined, const std::vector<Tetrahedron>& nodes,
                                              const std::set<Triangle>& split);

}  // namespace geomesh::geomodel::checking
