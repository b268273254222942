// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Faults along which the two sides are free to move.
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// The mesh with its nodes doubled along these surfaces. A node is there once for each sector of tetrahedra about it
/// that the surfaces divide. So it is there once at a tip inside the model, twice on a fault, three or four times where
/// faults meet. Each face of the surfaces is there twice: on NAME.minus and on NAME.plus, with the normal out of its
/// own side. A sheet has one side all over (turned_faces()). Nodes, curves and other faces stay with the sector of
/// lowest number. No tetrahedron has all its corners on one of the surfaces (with_free_corners()). With `cohesive`,
/// prisms of no thickness between the two sides are a layer NAME.layer. Throws Error{usage} where no inner face is on a
/// surface of such a name.
ModelMesh split_along(const ModelMesh& mesh, const std::vector<std::string>& surfaces, bool cohesive);

/// The same with where each node comes from, but without free corners: tetrahedra are those of the mesh.
struct SplitMesh {
  ModelMesh mesh;
  std::vector<VertexIndex> original;  ///< of each node: its row before
};
SplitMesh split_with_origins(const ModelMesh& mesh, const std::vector<std::string>& surfaces, bool cohesive);

}  // namespace geomesh::geomodel
