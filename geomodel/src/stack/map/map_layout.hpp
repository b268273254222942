// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Makes the first triangulation of the map: its rim, a lattice of points, and the constraint lines.
#pragma once

#include <vector>

#include "rules/planar/planar_lines.hpp"
#include "stack/map/map_samples.hpp"

namespace geomesh::geomodel {

struct MapLayout {
  MapBounds bounds;                      ///< the rim of the triangulation lies exactly on these bounds
  double lattice = 1;                    ///< spacing of the triangular lattice of points inside the bounds
  std::vector<std::vector<Vec2>> lines;  ///< constraint lines of the triangulation, clipped at its rim
  double joined_within = 0;              ///< constraint lines that are at most this far apart are merged
  /// Whether constraint lines are kept exactly; if not, points that they put very close together are merged.
  bool keeps_lines = false;
};

LinedTriangulation triangulate_layout(const MapLayout& layout);

}  // namespace geomesh::geomodel
