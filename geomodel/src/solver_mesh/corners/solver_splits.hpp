// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Lists which solvers duplicate the nodes of faults themselves.
#pragma once

#include <string_view>

namespace geomesh::geomodel {

/// Returns whether the solver of a format splits faults itself when it reads the mesh, so that it refuses a mesh that
/// is split already.
inline bool solver_splits_faults(std::string_view format) { return format == "seissol"; }

}  // namespace geomesh::geomodel
