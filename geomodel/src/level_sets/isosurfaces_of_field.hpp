// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Computes all isosurfaces of one field within a given distance of the true ones.
#pragma once

#include <string>
#include <vector>

#include "level_sets/fields/read_field.hpp"
#include "level_sets/mesh/isosurface.hpp"

namespace geomesh::geomodel {

struct FieldSurfaces {
  std::vector<Isosurface> surfaces;  ///< surfaces in the order of the isovalues
  double distance = 0;               ///< distance from the true isosurfaces; 0: equal up to rounding
  bool is_proven = true;             ///< false if the distance was tested at samples only
  std::size_t n_samples = 0;         ///< number of samples for each surface, if it is not proven
  /// For each surface, the triangles for which the distance was neither proven nor found at samples.
  std::vector<std::vector<Index>> beyond;
  std::size_t n_cells = 0;       ///< number of cells of the background mesh
  std::vector<Box3> unresolved;  ///< bounding boxes of cells in which an isosurface may have several sheets
  Range found;                   ///< range of the field's values at the vertices of the mesh
};

/// Meshes the box, refines the mesh where isosurfaces pass, and repeats until all triangles are within the distance.
/// `values` are ascending. Throws as the field does, and Error{cannot_mesh} if too many cells would be needed.
FieldSurfaces isosurfaces_of(const ScalarField& field, const Box3& box, const std::vector<double>& values,
                             double distance);

/// Computes the isosurfaces of a field that is linear in tetrahedra, which are exact up to rounding.
FieldSurfaces isosurfaces_of(const TetrahedralField& field, const std::vector<double>& values);

}  // namespace geomesh::geomodel
