// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `geomesh check --solver`: checks a mesh in a file for use with solvers.
#pragma once

#include <map>
#include <string>

#include "geomesh/geomodel/check.hpp"
#include "mesh_readers/mesh_files.hpp"

namespace geomesh::geomodel {

/// Velocities by the name of the unit or region.
using Velocities = std::map<std::string, double>;

/// Checks a mesh in a file for use with solvers and sets result.solver. Adds a fault `unfit_for_solvers` if it fails.
void check_for_solvers(const checking::MeshFile& file, const Velocities& velocities, CheckResult& result);

}  // namespace geomesh::geomodel
