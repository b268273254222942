// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Assigns names, numbers and measures anew to a mesh that has been changed.
#pragma once

#include <set>
#include <utility>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Assigns ids in the order of docs/output-files.md: regions keep theirs, which begin with 1, followed by surfaces,
/// curves, points and sets.
void renumber_ids(ModelMesh& mesh);

/// Numbers patches from 1 in the order of their first faces. A patch consists of faces connected across edges at which
/// exactly two faces with the same surfaces meet.
void number_patches(ModelMesh& mesh);

/// Set of mesh edges, each stored as its two node numbers in ascending order.
using EdgeSet = std::set<std::pair<VertexIndex, VertexIndex>>;

/// Renames the curves of those of these mesh edges that are intersections, by the surfaces of the faces around each
/// edge. Wells and fault tips are kept, and curves left without an edge are removed.
void name_intersections(ModelMesh& mesh, const EdgeSet& edges);

/// Computes the number of tetrahedra and the volume of each region, the area of each surface, and the length of each
/// curve.
void measure_again(ModelMesh& mesh);

}  // namespace geomesh::geomodel
