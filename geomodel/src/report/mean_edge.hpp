// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The mean edge length of a mesh.
#pragma once

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Returns the mean length of the edges of all tetrahedra; an edge counts once for each tetrahedron that has it. An
/// empty mesh has the mean 0. Linear time.
double mean_edge(const ModelMesh& mesh);

}  // namespace geomesh::geomodel
