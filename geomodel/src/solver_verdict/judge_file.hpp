// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `geomesh check --solver`: checks for solvers a mesh as it is in a file.
#pragma once

#include <map>
#include <string>

#include "geomesh/geomodel/check.hpp"
#include "mesh_readers/mesh_files.hpp"

namespace geomesh::geomodel {

/// Velocities by unit or region.
using Velocities = std::map<std::string, double>;

/// Sets result.solver; adds a fault `unfit_for_solvers` if the mesh does not pass.
void check_for_solvers(const checking::MeshFile& file, const Velocities& velocities, CheckResult& result);

}  // namespace geomesh::geomodel
