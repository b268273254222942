// SPDX-License-Identifier: MIT
/// @file
/// A component of a mesh as a mesh of its own.
#pragma once

#include <vector>

#include "remesh/domain/domain_mesh.hpp"

namespace geomesh::remesh {

/// The cells of one component, with the curves that run along their edges. Faces to other components are constrained
/// and have no neighbour. Patches and classes of curves are those of the whole, which alone knows them.
struct MeshPart {
  DomainMesh mesh;
  std::vector<VertexIndex> vertices;  ///< rows in the whole, of the part's first vertices: those that it began with
};

}  // namespace geomesh::remesh
