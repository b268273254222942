// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Shift of a field with which the triangles of its isosurfaces enclose the volumes of the isosurfaces.
#pragma once

#include <vector>

#include "level_sets/mesh/isosurface.hpp"

namespace geomesh::geomodel {

/// By vertex of the mesh, what is to be taken from the field: the value less the mean of the field's values over the
/// triangles in the cells at the vertex. `surfaces` are those of the field itself, one for each of `values` (rising).
/// All surfaces take part in one shift, so that they keep their order. At no vertex does the field less the shift
/// change to the other side of a value, so that the surfaces keep their topology.
std::vector<double> balancing_shift(const BackgroundMesh& mesh, const ScalarField& field,
                                    const std::vector<Isosurface>& surfaces, const std::vector<double>& values);

}  // namespace geomesh::geomodel
