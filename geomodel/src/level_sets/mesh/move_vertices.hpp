// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Moves vertices of the background mesh onto isosurfaces that pass very close to them.
#pragma once

#include <vector>

#include "level_sets/mesh/crossed_edges.hpp"

namespace geomesh::geomodel {

/// Moves each vertex to the nearest crossing of an isosurface with one of its edges, if that is within a quarter of the
/// edge's length; the vertex gets the isovalue. A vertex is not moved if a cell would lose nine tenths of its volume,
/// or if the vertex would leave a side of the box.
void move_vertices(const BackgroundMesh& mesh, const CrossedEdges& edges, const std::vector<double>& values,
                   MovedVertices& vertices);

}  // namespace geomesh::geomodel
