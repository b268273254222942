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
/// nearest (alternating projections), on a side along the axes within that side. It stays half-way where that is
/// farther than the tolerance, where the surface ends at the edge (borders, tips), and on slanting sides. Faces are
/// looked at in ten places: where one would be farther from its surface than the tolerance its edges stay straight.
/// Where the Jacobian of an element is not proven positive (second_order.hpp), its edges' curvature is halved up to
/// three times, then given up.
///
/// O(n log n) in the faces and the input's triangles. The same input gives the same places.
std::vector<CurvedEdge> curved_edges(const ModelMesh& mesh, const std::vector<TriangulatedSurface>& surfaces,
                                     double tolerance);

}  // namespace geomesh::geomodel
