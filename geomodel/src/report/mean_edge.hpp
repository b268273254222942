// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// How long the edges of a mesh came out.
#pragma once

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Mean length of the edges of all tetrahedra; an edge counts once for each tetrahedron that has it. Empty: 0. Linear.
double mean_edge(const ModelMesh& mesh);

}  // namespace geomesh::geomodel
