// SPDX-License-Identifier: MIT
/// @file
/// Delaunay triangulation in a plane, by the same base, the same two predicates and the same perturbation as in space.
#pragma once

#include <span>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh {

/// The whole convex hull, ghost cells included.
struct DelaunayTriangulation {
  TriMesh mesh;  ///< vertex ids are rows of the points given
  std::vector<VertexIndex>
      representative;  ///< per point: itself, or the first point with equal coordinates (which alone is in the mesh)
};

/// Triangles turn left. Throws Error{invalid_input} on unsafe coordinates, Error{cannot_mesh} where all points lie on
/// one line.
DelaunayTriangulation delaunay_triangulation(std::span<const Vec2> points);

}  // namespace geomesh
