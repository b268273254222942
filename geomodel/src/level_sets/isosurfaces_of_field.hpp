// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// All isosurfaces of one field, within a distance of the field's own.
#pragma once

#include <string>
#include <vector>

#include "level_sets/fields/read_field.hpp"
#include "level_sets/mesh/isosurface.hpp"

namespace geomesh::geomodel {

struct FieldSurfaces {
  std::vector<Isosurface> surfaces;  ///< in the order of the values
  double distance = 0;               ///< within which the surfaces are of the field's own; 0: the same up to rounding
  bool is_proven = true;             ///< false: found for samples
  std::size_t n_samples = 0;         ///< per surface, where it is not proven
  std::vector<std::vector<Index>> beyond;  ///< per surface: triangles for which neither was reached
  std::size_t n_cells = 0;                 ///< of the background mesh
  std::vector<Box3> unresolved;            ///< bounds of cells in which an isosurface may have several sheets
  Range found;                             ///< the values that the field takes at the vertices of the mesh
};

/// Meshes the box, refines the mesh where isosurfaces pass, and repeats until all triangles are within the distance.
/// `values` rise. Throws as the field, and Error{cannot_mesh} where too many cells would be needed.
FieldSurfaces isosurfaces_of(const ScalarField& field, const Box3& box, const std::vector<double>& values,
                             double distance);

/// The same for a field that is linear in tetrahedra: its isosurfaces are what they are, to rounding.
FieldSurfaces isosurfaces_of(const TetrahedralField& field, const std::vector<double>& values);

}  // namespace geomesh::geomodel
