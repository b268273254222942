// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Names, numbers and measures of a mesh that has been changed.
#pragma once

#include <set>
#include <utility>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Ids in the order of docs/output-files.md: regions as they stand, from 1, then surfaces, curves, points and sets.
void renumber_ids(ModelMesh& mesh);

/// Patches from 1, in the order of their first faces: faces joined across edges where exactly two faces of one set
/// meet.
void number_patches(ModelMesh& mesh);

/// Edges by their ends, the lesser first.
using EdgeSet = std::set<std::pair<VertexIndex, VertexIndex>>;

/// Names the intersections among these edges anew, by the faces about each; wells and tips stay. Curves that are left
/// without an edge go.
void name_intersections(ModelMesh& mesh, const EdgeSet& edges);

/// Tetrahedra and volume of each region, area of each surface, length of each curve.
void measure_again(ModelMesh& mesh);

}  // namespace geomesh::geomodel
