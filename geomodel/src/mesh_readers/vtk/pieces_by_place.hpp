// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Pieces of a mesh in parts that tell no global numbers, as ParaView and other tools write them.
#pragma once

#include <vector>

#include "mesh_readers/mesh_files.hpp"

namespace geomesh::geomodel::checking {

/// The tetrahedra of the pieces one after the other, without those that are ghosts (cell array `vtkGhostType`). Points
/// in the same place, to the last bit, are one. Arrays that not all pieces have are left out, as are midpoints. O(n log
/// n).
MeshFile merged_by_place(std::vector<MeshFile> pieces);

}  // namespace geomesh::geomodel::checking
