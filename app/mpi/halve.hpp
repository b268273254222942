// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Every edge cut in two: a triangle becomes four, a tetrahedron eight. Points are at the middles of edges, which do
/// not depend on who asks. So parts on different ranks, and the model's surfaces, are cut alike.
#pragma once

#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::app {

/// O(n log n). Throws Error{cannot_mesh} where a tetrahedron is so flat that rounding turns a piece over.
void halve_tetrahedra(std::vector<Vec3>& points, std::vector<Tetrahedron>& tetrahedra, std::vector<Index>& component);

/// Faces and edges of curves; tetrahedra stay as they are. Points are added behind those that are there.
void halve_surfaces(geomodel::ModelMesh& mesh);

}  // namespace geomesh::app
