// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Maps properties from files onto the cells or points of a mesh.
#pragma once

#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"
#include "geomesh/geomodel/write_options.hpp"

namespace geomesh::geomodel {

/// Adds a cell or point array for each field. It is evaluated at the centroids of tetrahedra, or at points and
/// midpoints, with the origin added again.
///   - A grid of any format that is read as a surface (GeoTIFF, Esri, Surfer, ZMAP ...): its values as a function of
///   the
///     place on the map. Linear between the nodes of a grid along the axes; of others, and of grids with holes, the
///     mean of the eight nearest, weighted by one over the squared distance. Beyond the grid: the value at its nearest
/// place.
///   - Values in space (.csv, .txt, .xyz: x y z value; .vti, .vtu, .vtp: the array of the field's name): likewise.
/// A field whose name the mesh has already replaces it. Throws Error{usage} if a file cannot be opened,
/// Error{invalid_input} if it holds no values.
void add_fields(ModelMesh& mesh, const std::vector<FieldSpec>& fields);

}  // namespace geomesh::geomodel
