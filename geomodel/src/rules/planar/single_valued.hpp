// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Whether a surface has one height over each place of the map.
#pragma once

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// No triangle is vertical, and no edge has more than two triangles. Triangles that share an edge lie on both sides of
/// it in the map. All is decided exactly. Sheets that lie over each other are not found here. Cost: a sort of the
/// edges.
bool is_single_valued(const TriangulatedSurface& surface);

}  // namespace geomesh::geomodel
