// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Lines of the map that lie in each other but for rounding, made one.
#pragma once

#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// The lines with vertices merged that are no further apart than `reach`, and each piece led through the vertices that
/// are no further from it. Pieces that lay side by side then are the same pieces. The first vertex of those merged, in
/// the order of the lines, stays.
///
/// Cost: vertices and pieces times their logarithm, and for each piece the vertices over its width in x.
std::vector<std::vector<Vec2>> join_lines(std::vector<std::vector<Vec2>> lines, double reach);

}  // namespace geomesh::geomodel
