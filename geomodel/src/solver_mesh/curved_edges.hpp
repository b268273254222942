// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Places the midpoints of second-order elements on the curved surfaces of the input.
#pragma once

#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Computes midpoints, on the surfaces of the input, for mesh edges that lie on surfaces. The mesh follows the input
/// within `tolerance`. `surfaces` are the surfaces that were meshed, in the coordinates of the mesh;
/// ModelMesh::surfaces has their names. A midpoint is moved to the nearest point of its surface. On an edge of several
/// surfaces it is moved to the nearest point where they meet (alternating projections). On a side of the model it
/// remains in the plane of that side. It remains half-way between the ends of its edge if it would move farther than
/// the tolerance, if the surface ends at the edge (borders, tips), on sides that are not plane, and on two oblique
/// sides at once. Every face with a curved edge is proven to lie completely within the tolerance of each of its
/// surfaces (curved_face.hpp); if this fails, its edges become straight. If the Jacobian of an element is not proven
/// positive (second_order.hpp), the curvature of its edges is halved up to three times, then removed. Its faces are
/// then proven again.
///
/// O(n log n) in the faces and the input's triangles. The same input gives the same places.
std::vector<CurvedEdge> curved_edges(const ModelMesh& mesh, const std::vector<TriangulatedSurface>& surfaces,
                                     double tolerance);

}  // namespace geomesh::geomodel
