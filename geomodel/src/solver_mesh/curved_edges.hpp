// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Midpoints on curved input, for elements of second order.
#pragma once

#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Places for the midpoints of mesh edges on surfaces: on the input, where the mesh follows it within `tolerance`.
/// `surfaces`: as meshed, in the mesh's frame; ModelMesh::surfaces names them.
///
/// A midpoint goes to the nearest point of its surface. On an edge of several surfaces it goes to where they meet
/// nearest (alternating projections). On a side of the model it stays in the plane of that side. It stays half-way
/// where that is farther than the tolerance, and where the surface ends at the edge (borders, tips). So it does on
/// sides that are not plane, and on two slanting sides at once. Each face with a curved edge is proven to lie within
/// the tolerance of each of its surfaces, all of it (curved_face.hpp). Where that is not so its edges become straight.
/// Where the Jacobian of an element is not proven positive (second_order.hpp), its edges' curvature is halved up to
/// three times, then given up. Its faces are then proven again.
///
/// O(n log n) in the faces and the input's triangles. The same input gives the same places.
std::vector<CurvedEdge> curved_edges(const ModelMesh& mesh, const std::vector<TriangulatedSurface>& surfaces,
                                     double tolerance);

}  // namespace geomesh::geomodel
