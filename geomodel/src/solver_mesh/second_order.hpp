// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Elements of second order: adds midpoint nodes and proves positive Jacobians.
#pragma once

#include <array>
#include <cstddef>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Returns the mean of two values, rounded; by coordinates this is the midpoint node of a straight edge.
double half_way(double a, double b);
Vec3 half_way(const Vec3& a, const Vec3& b);

/// Adds a node at the midpoint of every edge, or at the position in ModelMesh::curved_edges, shared by all cells at the
/// edge. Point arrays get the mean of the edge's ends there, or the values of the curved edge. Throws
/// Error{cannot_mesh} with the place if the Jacobian of an element is not proven positive.
void add_midpoints(ModelMesh& mesh);

/// Returns the number of second-order tetrahedra whose Jacobian is not proven positive; `first` is the row of the
/// first. The Jacobian's determinant is a polynomial of third degree; if all of its 20 Bezier coefficients are
/// positive, it is positive everywhere in the element (Johnen, Remacle and Geuzaine 2013). Rounding is bounded: a
/// coefficient counts as positive only if it exceeds its own error bound.
std::size_t n_unproven_jacobians(const ModelMesh& mesh, std::size_t* first = nullptr);

/// Returns whether the Jacobian of one tetrahedron is proven positive. Nodes are its corners, followed by the midpoints
/// of the edges 01 12 20 03 13 23.
bool jacobian_is_positive(const std::array<Vec3, 10>& nodes);

}  // namespace geomesh::geomodel
