// SPDX-License-Identifier: MIT
/// @file
/// Delaunay triangulation in a plane, with the same base class, the same two predicates and the same perturbation as in
/// space.
#pragma once

#include <span>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh {

/// The triangulation of the whole convex hull, including ghost cells.
struct DelaunayTriangulation {
  TriMesh mesh;  ///< vertex ids are rows of the given points
  std::vector<VertexIndex>
      /// For each point: itself, or the first point with equal coordinates (only that one is in the mesh).
      representative;
};

/// Triangles are counter-clockwise. Throws Error{invalid_input} for unsafe coordinates, Error{cannot_mesh} if all
/// points lie on one line.
DelaunayTriangulation delaunay_triangulation(std::span<const Vec2> points);

}  // namespace geomesh
