// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes cell and point arrays to an Exodus file: variables of element blocks and of nodes, at time 0.
#pragma once

#include "formats/exodus/netcdf_writer.hpp"
#include "solver_mesh/solver_mesh.hpp"

namespace geomesh::geomodel {

/// Adds cell and point arrays to an Exodus file that has its element blocks already. Elements that are not tetrahedra
/// have NaN. The mesh must exist until the file is written. Returns the names of the arrays.
std::vector<std::string> add_exodus_fields(NetcdfWriter& file, const SolverMesh& mesh);

}  // namespace geomesh::geomodel
