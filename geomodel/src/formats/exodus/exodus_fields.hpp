// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Cell and point arrays in an Exodus file: variables of element blocks and of nodes, at time 0.
#pragma once

#include "formats/exodus/netcdf_writer.hpp"
#include "solver_mesh/solver_mesh.hpp"

namespace geomesh::geomodel {

/// Adds them to a file whose blocks are added already; elements that are no tetrahedra have NaN. The mesh must outlive
/// the file's writing. Returns the names.
std::vector<std::string> add_exodus_fields(NetcdfWriter& file, const SolverMesh& mesh);

}  // namespace geomesh::geomodel
