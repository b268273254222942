// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Velocities that a model's attributes give, as judge_for_solvers takes them.
#pragma once

#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// By region id - 1: the attribute `vp`; 0 where it is not known.
std::vector<double> velocity_by_region(const ModelMesh& mesh);

}  // namespace geomesh::geomodel
