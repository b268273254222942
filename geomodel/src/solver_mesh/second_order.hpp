// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Adds the midpoint nodes of second-order elements and proves that their Jacobians are positive.
#pragma once

#include <array>
#include <cstddef>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Returns the rounded mean of two numbers. Applied to each coordinate, it gives the midpoint node of a straight edge.
double half_way(double a, double b);
Vec3 half_way(const Vec3& a, const Vec3& b);

/// Makes the mesh one of second order. Each edge gets a node at its midpoint, or at the position in
/// ModelMesh::curved_edges, which all cells at the edge share. Point arrays have there the mean of the values at the
/// ends, or the values of the curved edge. Throws Error{cannot_mesh} with the place if the Jacobian of an element is
/// not proven positive.
void add_midpoints(ModelMesh& mesh);

/// Returns the number of second-order tetrahedra whose Jacobian is not proven positive; `first` is set to the row of
/// the first of them. The Jacobian's determinant is a polynomial of third degree; if all of its 20 Bezier coefficients
/// are positive, it is positive everywhere in the element (Johnen, Remacle and Geuzaine 2013). Rounding is bounded: a
/// coefficient counts as positive only if it exceeds its own error bound.
std::size_t n_unproven_jacobians(const ModelMesh& mesh, std::size_t* first = nullptr);

/// Returns whether the Jacobian of one second-order tetrahedron is proven positive. Its nodes are its corners, followed
/// by the midpoints of the edges 01 12 20 03 13 23.
bool jacobian_is_positive(const std::array<Vec3, 10>& nodes);

}  // namespace geomesh::geomodel
