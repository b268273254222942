// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Extracts the triangles of isosurfaces from a background mesh.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "level_sets/mesh/background_mesh.hpp"

namespace geomesh::geomodel {

struct Isosurface {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;  ///< triangles, whose normals point to where the field increases
  std::vector<std::size_t> cell;    ///< for each triangle: the cell of the background mesh in which it lies
  std::vector<Vec3> gradient;       ///< for each triangle: gradient of the linear function in its cell
};

/// Returns one isosurface for each of `values` (ascending), by marching tetrahedra with three changes:
/// - vertices are the field's own roots on the edges of the mesh, to rounding, not those of the linear function;
/// - the field is shifted a little before (balancing_shift), so that the mean of its values over the triangles is the
///   isovalue. With corners on the true isosurface, all triangles of a convex surface would lie inside it;
/// - a vertex of the mesh that is very near to a root on one of its edges is first moved to this root, so that no
///   triangle is much smaller than its cell (isosurface stuffing, Labelle and Shewchuk 2007).
///
/// Isosurfaces of different values never cross, up to the rounding of their vertices: on each edge their roots have the
/// order of the values, and in each cell they are divided into triangles by the same rule.
///
/// If `field` is null, the field is linear between the vertices of the mesh, which are then not moved.
std::vector<Isosurface> extract_isosurfaces(const BackgroundMesh& mesh, const ScalarField* field,
                                            const std::vector<double>& values);

}  // namespace geomesh::geomodel
