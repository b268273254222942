// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Which side of a fault is which, all over the fault.
#pragma once

#include <cstdint>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// A face's normal points from the lower region to the higher one, so along a fault with throw it changes sides. Tells
/// which faces have to be turned so that all of a fault have their normal on one side. `fault_of`: by face the id of
/// its fault, 0 where it is on none. Faces are joined across edges where just two faces of the fault meet. Pieces that
/// are not joined face as the largest does; that is turned where most of its area was. Of a sheet with one side alone
/// the faces stay as they are. O(n log n) in the faces of faults.
std::vector<bool> turned_faces(const ModelMesh& mesh, const std::vector<std::int32_t>& fault_of);

}  // namespace geomesh::geomodel
