// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Divides a horizon with throw into blocks that end at its faults.
#pragma once

#include <string>
#include <vector>

#include "rules/extend/extend.hpp"

namespace geomesh::geomodel {

/// Returns the row of a fault that a horizon lists under throw_at. Throws Error{usage} if no surface has this name.
std::size_t throw_fault(const std::vector<TriangulatedSurface>& surfaces, const TriangulatedSurface& horizon,
                        const std::string& name);

/// Assigns the triangles of horizon `s` to blocks and extends each block on its own. Faults across which a sheet
/// continues do not divide the horizon. If the triangles that cross faults cannot be replaced, the horizon is divided
/// only at faults through the whole model, or is left as given, with warnings. Sets the horizon's rows in `built.rows`.
void build_blocks(BuiltSurfaces& built, std::size_t s, const ModelRules& rules, const BuildLog& log);

}  // namespace geomesh::geomodel
