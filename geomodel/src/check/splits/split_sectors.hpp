// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Sectors of tetrahedra about the points of split surfaces.
#pragma once

#include <set>
#include <vector>

#include "check/judged/judged_mesh.hpp"

namespace geomesh::geomodel::checking {

/// Tetrahedra by places.
struct JoinedCells {
  std::size_t n_points;
  const std::vector<Tetrahedron>& tetrahedra;
};

/// Places that have not one node for each sector. A sector is a set of tetrahedra about a place that are joined by
/// faces which are not split. `nodes` are the same tetrahedra, corner for corner, by the nodes of the file. Ascending.
/// O(n log n).
std::vector<VertexIndex> nodes_unlike_sectors(const JoinedCells& joined, const std::vector<Tetrahedron>& nodes,
                                              const std::set<Triangle>& split);

}  // namespace geomesh::geomodel::checking
