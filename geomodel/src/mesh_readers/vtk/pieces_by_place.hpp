// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Combines the pieces of a mesh that have no global numbers, as ParaView and other tools write them.
#pragma once

#include <vector>

#include "mesh_readers/mesh_files.hpp"

namespace geomesh::geomodel::checking {

/// Concatenates the tetrahedra of the pieces, without those that are ghosts (cell array `vtkGhostType`). Points with
/// exactly equal coordinates are merged. Midpoints and arrays that not all pieces have are left out. O(n log n).
MeshFile merged_by_place(std::vector<MeshFile> pieces);

}  // namespace geomesh::geomodel::checking
