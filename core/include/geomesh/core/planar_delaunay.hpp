// SPDX-License-Identifier: MIT
/// @file
/// Delaunay triangulation in a plane. It shares the mesh class, the predicates (in-circle and orientation) and the
/// symbolic perturbation with the Delaunay tetrahedralization.
#pragma once

#include <span>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh {

/// The triangulation of the whole convex hull, including ghost cells.
struct DelaunayTriangulation {
  TriMesh mesh;  ///< a vertex id is the index of its point in the input
  /// For each point its own index, or that of the first point with equal coordinates (only that one is in the mesh).
  std::vector<VertexIndex> representative;
};

/// Computes the Delaunay triangulation of the points, with counter-clockwise triangles. Throws Error{invalid_input} for
/// coordinates that the exact predicates cannot handle, Error{cannot_mesh} if all points lie on one line.
DelaunayTriangulation delaunay_triangulation(std::span<const Vec2> points);

}  // namespace geomesh
