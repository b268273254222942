// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Velocities from a model's attributes, in the form that judge_for_solvers needs.
#pragma once

#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Returns the attribute `vp` by region id - 1; 0 if it is not known.
std::vector<double> velocity_by_region(const ModelMesh& mesh);

}  // namespace geomesh::geomodel
