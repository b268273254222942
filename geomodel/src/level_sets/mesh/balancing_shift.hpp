// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Shifts a field so that the triangles of its isosurfaces enclose the same volumes as the true isosurfaces.
#pragma once

#include <vector>

#include "level_sets/mesh/isosurface.hpp"

namespace geomesh::geomodel {

/// Returns, by vertex of the mesh, what to subtract from the field: the isovalue minus the mean of the field's values
/// over the triangles in the cells around the vertex. `surfaces` are those of the unshifted field, one for each of
/// `values` (ascending). All surfaces share one shift, so that they keep their order. At no vertex does the shifted
/// field cross an isovalue, so that the surfaces keep their topology.
std::vector<double> balancing_shift(const BackgroundMesh& mesh, const ScalarField& field,
                                    const std::vector<Isosurface>& surfaces, const std::vector<double>& values);

}  // namespace geomesh::geomodel
