// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// No tetrahedron keeps all of its corners on a fault that is to be split.
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// The mesh in which no tetrahedron has all four corners on inner faces of one of these surfaces: each that had is
/// divided into four about its centre. Solvers that insert cohesive cells or constrain the nodes of a fault cannot tell
/// on which side such a tetrahedron lies (geodynamics/pylith#795). Nothing else changes: faces, curves and the rows of
/// points and of other tetrahedra are kept. The new point has the mean of each point array, its tetrahedra the cell
/// values of the old one. Names that no surface has are passed over. Throws Error{cannot_mesh} with the place where a
/// tetrahedron is too flat for a centre in doubles. O(tetrahedra).
ModelMesh with_free_corners(const ModelMesh& mesh, const std::vector<std::string>& surfaces);

/// Rows of the tetrahedra with all four corners on inner faces of one of these surfaces, rising.
std::vector<std::size_t> tetrahedra_on_surfaces(const ModelMesh& mesh, const std::vector<std::string>& surfaces);

}  // namespace geomesh::geomodel
