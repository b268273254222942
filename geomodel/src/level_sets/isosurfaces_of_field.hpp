// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Computes isosurfaces of a scalar field within a given distance of the true isosurfaces.
#pragma once

#include <string>
#include <vector>

#include "level_sets/fields/read_field.hpp"
#include "level_sets/mesh/isosurface.hpp"

namespace geomesh::geomodel {

struct FieldSurfaces {
  std::vector<Isosurface> surfaces;  ///< one isosurface for each isovalue, in the same order
  double distance = 0;               ///< proven or tested distance from the true isosurfaces; 0: equal up to rounding
  bool is_proven = true;             ///< false if the distance from the true isosurfaces was tested only at samples
  std::size_t n_samples = 0;         ///< number of samples for each isosurface, if its distance is not proven
  /// For each isosurface, the rows of triangles not proven to be within `distance`, or not within it at samples.
  std::vector<std::vector<Index>> beyond;
  std::size_t n_cells = 0;       ///< number of cells of the background mesh from which isosurfaces are made
  std::vector<Box3> unresolved;  ///< bounding boxes of background cells in which an isosurface may have several parts
  Range found;                   ///< range of the field's values at the vertices of the background mesh
};

/// Computes the isosurfaces of a field in a box for ascending `values`. A background mesh of the box is refined where
/// isosurfaces pass, until all triangles are within the distance. Throws what the field throws, and Error{cannot_mesh}
/// if too many cells would be needed.
FieldSurfaces isosurfaces_of(const ScalarField& field, const Box3& box, const std::vector<double>& values,
                             double distance);

/// Computes the isosurfaces of a field that is linear in tetrahedra, which are exact up to rounding.
FieldSurfaces isosurfaces_of(const TetrahedralField& field, const std::vector<double>& values);

}  // namespace geomesh::geomodel
