// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines whether a surface has one height over each place of the map.
#pragma once

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Returns whether a surface has one height over each place: no triangle is vertical, no edge has more than two
/// triangles, and triangles with a common edge lie on different sides of it in the map. All tests are exact. Connected
/// parts of the surface that lie above each other are not detected. Cost: a sort of the edges.
bool is_single_valued(const TriangulatedSurface& surface);

}  // namespace geomesh::geomodel
