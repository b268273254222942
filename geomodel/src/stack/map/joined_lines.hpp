// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Merges lines of the map that coincide up to rounding.
#pragma once

#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// Returns the lines after vertices at most `reach` apart were merged, and each segment was routed through the vertices
/// that are at most that far from it. Segments that lay side by side are then identical. Of merged vertices, the first
/// one in the order of the lines is kept. O(n log n), and for each segment the vertices within its range of x.
std::vector<std::vector<Vec2>> join_lines(std::vector<std::vector<Vec2>> lines, double reach);

}  // namespace geomesh::geomodel
