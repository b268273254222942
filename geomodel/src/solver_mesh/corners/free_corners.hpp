// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Ensures that no tetrahedron has all of its corners on a fault that is to be split.
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Returns a mesh in which no tetrahedron has all four corners on inner faces of one of these surfaces: each such
/// tetrahedron is divided into four around its centre. Solvers that insert cohesive cells or constrain the nodes of a
/// fault cannot know on which side such a tetrahedron lies (geodynamics/pylith#795). Nothing else changes: faces,
/// curves and the rows of points and of other tetrahedra are kept. At a new point, each point array has the mean of its
/// values at the four corners; new tetrahedra have the cell values of the divided one. Names in `surfaces` that no
/// surface has are ignored. Throws Error{cannot_mesh} with the place if a tetrahedron is too flat for a centre in
/// doubles. O(tetrahedra).
ModelMesh with_free_corners(const ModelMesh& mesh, const std::vector<std::string>& surfaces);

/// Returns the rows, ascending, of tetrahedra with all four corners on faces inside the mesh on one of these surfaces.
std::vector<std::size_t> tetrahedra_on_surfaces(const ModelMesh& mesh, const std::vector<std::string>& surfaces);

}  // namespace geomesh::geomodel
