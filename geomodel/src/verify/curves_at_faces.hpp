// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Checks curves and patches of a finished mesh against the faces at each edge.
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Checks curves and patches of surfaces against the mesh faces at each edge, and appends a sentence for each kind of
/// defect. If exactly two faces with the same set of surfaces meet at an edge, both must belong to one patch, and only
/// wells may be on the edge. Any other edge of such faces must be on exactly one curve that is not a well. O(n log n)
/// for n faces. Precondition: all indices in the mesh are in range.
void check_curves_at_faces(const ModelMesh& mesh, std::vector<std::string>& faults);

}  // namespace geomesh::geomodel
