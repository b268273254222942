// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Takes velocities from the attributes of a model, in the form that judge_for_solvers needs.
#pragma once

#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Returns the velocity of compressional waves (attribute `vp`) at index region id - 1; 0 if it is not known.
std::vector<double> velocity_by_region(const ModelMesh& mesh);

}  // namespace geomesh::geomodel
