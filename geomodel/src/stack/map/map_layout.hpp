// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The first triangulation of the map: its rim, a lattice, and the lines that it has to hold.
#pragma once

#include <vector>

#include "rules/planar/planar_lines.hpp"
#include "stack/map/map_samples.hpp"

namespace geomesh::geomodel {

struct MapLayout {
  MapBounds bounds;                      ///< the rim lies on it exactly
  double lattice = 1;                    ///< distance of its points
  std::vector<std::vector<Vec2>> lines;  ///< cut off at the rim
  double joined_within = 0;              ///< lines no further apart are one
  bool keeps_lines = false;              ///< else points that lines leave very near to each other merge
};

LinedTriangulation triangulate_layout(const MapLayout& layout);

}  // namespace geomesh::geomodel
