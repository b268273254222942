// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `geomesh check --solver`: checks a mesh in a file for use with solvers.
#pragma once

#include <map>
#include <string>

#include "geomesh/geomodel/check.hpp"
#include "mesh_readers/mesh_files.hpp"

namespace geomesh::geomodel {

using Velocities = std::map<std::string, double>;

/// Checks a mesh in a file for use with solvers, sets result.solver, and reports a failure as `unfit_for_solvers`.
void check_for_solvers(const checking::MeshFile& file, const Velocities& velocities, CheckResult& result);

}  // namespace geomesh::geomodel
