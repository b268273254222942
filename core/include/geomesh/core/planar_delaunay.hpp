// SPDX-License-Identifier: MIT
/// @file
/// Delaunay triangulation in a plane: of a map, or of a facet's points where they lie in space. By the same base, the
/// same two predicates and the same perturbation as in space, so that the draft of a facet breaks ties as the
/// tetrahedra do.
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

/// Of points that lie exactly in one plane. Triangles turn left seen along the axis that is dropped: the first of x, y,
/// z that is not parallel to the plane, projected to (y, z), (z, x), (x, y). A facet of the Delaunay tetrahedralization
/// that is present equals this triangulation of its points. Throws as above, and Error{invalid_input} naming the first
/// point that is off the plane.
DelaunayTriangulation delaunay_triangulation_in_plane(std::span<const Vec3> points);

}  // namespace geomesh
