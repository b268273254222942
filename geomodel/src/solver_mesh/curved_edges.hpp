// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Places midpoints of second-order elements on the curved input.
#pragma once

#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Computes the midpoints of mesh edges on surfaces: on the input, if the mesh follows it within `tolerance`.
/// `surfaces` are those that were meshed, in the mesh's frame; ModelMesh::surfaces has their names. A midpoint is moved
/// to the nearest point of its surface. On an edge of several surfaces it is moved to the nearest point where they meet
/// (alternating projections). On a side of the model it remains in the plane of that side. It remains half-way if it
/// would move farther than the tolerance, and where the surface ends at the edge (borders, tips). The same holds on
/// sides that are not plane, and on two oblique sides at once. Each face with a curved edge is proven to lie within the
/// tolerance of each of its surfaces, all of it (curved_face.hpp). Otherwise its edges become straight. If the Jacobian
/// of an element is not proven positive (second_order.hpp), the curvature of its edges is halved up to three times,
/// then removed. Its faces are then proven again.
///
/// O(n log n) in the faces and the input's triangles. The same input gives the same places.
std::vector<CurvedEdge> curved_edges(const ModelMesh& mesh, const std::vector<TriangulatedSurface>& surfaces,
                                     double tolerance);

}  // namespace geomesh::geomodel
