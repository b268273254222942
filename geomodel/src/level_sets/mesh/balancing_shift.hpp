// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Shifts a field so that the triangles of its isosurfaces enclose the same volumes as the true isosurfaces.
#pragma once

#include <vector>

#include "level_sets/mesh/isosurface.hpp"

namespace geomesh::geomodel {

/// Returns for each vertex of the mesh the number to subtract from the field: the mean, over the triangles in the cells
/// around the vertex, of the isovalue minus the field's value. `surfaces` are the isosurfaces of the field as it is,
/// one for each of `values` (ascending). All isosurfaces share one shift, so that they keep their order. At no vertex
/// does the shifted field change its side of an isovalue, so that the isosurfaces keep their topology.
std::vector<double> balancing_shift(const BackgroundMesh& mesh, const ScalarField& field,
                                    const std::vector<Isosurface>& surfaces, const std::vector<double>& values);

}  // namespace geomesh::geomodel
