// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Orients the faces of faults consistently, so that each side of a fault is the same everywhere.
#pragma once

#include <cstdint>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Returns which faces must be inverted so that all faces of a fault have their normals on the same side. In the mesh,
/// a face's normal points from the lower region id to the higher one, so along a fault with throw it changes sides.
/// `fault_of` is the id of each face's fault, 0 if it is on none. Faces are joined across edges at which exactly two
/// faces of the fault meet. Pieces that are not connected are oriented like the largest piece, which keeps the
/// orientation of most of its area. Faces of a connected piece that is one-sided, like a Moebius strip, are not
/// changed. O(n log n) in the faces of faults.
std::vector<bool> turned_faces(const ModelMesh& mesh, const std::vector<std::int32_t>& fault_of);

}  // namespace geomesh::geomodel
