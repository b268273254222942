// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Curves and patches of a finished mesh against the faces at each edge.
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Appends a sentence for each kind of fault. Two faces of one set that meet alone at an edge have one patch, and no
/// curve but a well is there. Any other edge of faces is on just one curve that is no well. O(n log n) for n faces.
/// Precondition: indices are in range.
void check_curves_at_faces(const ModelMesh& mesh, std::vector<std::string>& faults);

}  // namespace geomesh::geomodel
