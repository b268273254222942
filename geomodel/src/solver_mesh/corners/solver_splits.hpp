// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Solvers that double the nodes of faults themselves.
#pragma once

#include <string_view>

namespace geomesh::geomodel {

/// Whether the solver of this format splits faults as it reads the mesh, and refuses one that is split already.
inline bool solver_splits_faults(std::string_view format) { return format == "seissol"; }

}  // namespace geomesh::geomodel
