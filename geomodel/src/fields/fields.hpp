// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Maps properties from files onto the cells or points of a mesh.
#pragma once

#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"
#include "geomesh/geomodel/write_options.hpp"

namespace geomesh::geomodel {

/// Adds a cell or point array to the mesh for each property. It is evaluated at the centroids of tetrahedra, or at
/// points and midpoints, after the origin was added again. Files hold one of two kinds of values.
///   - A grid of any format that is read as a surface (GeoTIFF, Esri, Surfer, ZMAP ...): its heights are the values, by
///     place on the map. They are linear between the nodes of a complete grid along the axes. For other grids, the
///     value is the mean of the eight nearest nodes, weighted by one over the squared distance. Beyond the grid it is
///     the value at the nearest place of the grid.
///   - Values in space (.csv, .txt, .xyz: x y z value; .vti, .vtu, .vtp with an array of the property's name):
///     evaluated in the same way, in space. A property replaces an array of the mesh that has the same name. Throws
///     Error{usage} if a file cannot be opened, Error{invalid_input} if it holds no values.
void add_fields(ModelMesh& mesh, const std::vector<FieldSpec>& fields);

}  // namespace geomesh::geomodel
