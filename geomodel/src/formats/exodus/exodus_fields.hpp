// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Cell and point arrays in an Exodus file: variables of element blocks and of nodes, at time 0.
#pragma once

#include "solver_mesh/solver_mesh.hpp"

namespace geomesh::geomodel {

/// Puts them into an open file whose blocks are there already; elements that are no tetrahedra have NaN. Returns the
/// library's status: below 0 where it failed.
int put_exodus_fields(int file, const SolverMesh& mesh);

}  // namespace geomesh::geomodel
