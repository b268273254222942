// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Elements of second order.
#pragma once

#include <array>
#include <cstddef>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// The mean of two values, rounded; and where the node in the middle of a straight edge is, by coordinates.
double half_way(double a, double b);
Vec3 half_way(const Vec3& a, const Vec3& b);

/// Adds a node in the middle of every edge, or where ModelMesh::curved_edges says, the same for all cells at the edge.
/// Point arrays get the means of the edge's ends there, or the values of the curved edge.
/// Throws Error{cannot_mesh} with the place where the Jacobian of an element is not proven positive.
void add_midpoints(ModelMesh& mesh);

/// Tetrahedra of second order whose Jacobian is not proven positive. The Jacobian's determinant is a polynomial of
/// third degree; where all its 20 Bezier coefficients are positive, so is it everywhere in the element (Johnen, Remacle
/// and Geuzaine 2013). Rounding is bounded: a coefficient counts as positive only where it exceeds its own error bound.
std::size_t n_unproven_jacobians(const ModelMesh& mesh, std::size_t* first = nullptr);

/// The same for one tetrahedron: corners, then midpoints of the edges 01 12 20 03 13 23.
bool jacobian_is_positive(const std::array<Vec3, 10>& nodes);

}  // namespace geomesh::geomodel
