// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Splits faults so that their two sides can move independently of each other.
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Returns the mesh with its nodes duplicated along these surfaces. A node exists once for each sector into which the
/// surfaces divide the tetrahedra around it: once at a tip inside the model, twice on a fault, three or four times
/// where faults meet. Each face of the surfaces exists twice: on NAME.minus and on NAME.plus, with normals out of the
/// tetrahedra on its side. NAME.minus is the same side everywhere on a connected fault (turned_faces()). Original
/// nodes, curves and other faces belong to the first sector. Tetrahedra with all corners on one of the surfaces are
/// divided before (with_free_corners()). With `cohesive`, prisms of no thickness between the two sides form a layer
/// NAME.layer. Throws Error{usage} if no inner face is on a surface of that name.
ModelMesh split_along(const ModelMesh& mesh, const std::vector<std::string>& surfaces, bool cohesive);

/// A split mesh with the original node of each of its nodes. Its tetrahedra are those of the original mesh.
struct SplitMesh {
  ModelMesh mesh;
  std::vector<VertexIndex> original;  ///< for each node of the split mesh: its row in the original mesh
};
SplitMesh split_with_origins(const ModelMesh& mesh, const std::vector<std::string>& surfaces, bool cohesive);

}  // namespace geomesh::geomodel
