// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Divides every edge in two: a triangle becomes four, a tetrahedron eight. New points are midpoints of edges, which do
/// not depend on the rank, so that parts on different ranks and the model's surfaces are divided in the same way.
#pragma once

#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::app {

/// Divides each tetrahedron into eight. O(n log n). Throws Error{cannot_mesh} if rounding inverts a piece.
void halve_tetrahedra(std::vector<Vec3>& points, std::vector<Tetrahedron>& tetrahedra, std::vector<Index>& component);

/// Divides the faces of a model into four and edges of curves into two, but no tetrahedra. Points are appended.
void halve_surfaces(geomodel::ModelMesh& mesh);

}  // namespace geomesh::app
