// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Divides a horizon with throw into blocks that end at its faults.
#pragma once

#include <string>
#include <vector>

#include "rules/extend/extend.hpp"

namespace geomesh::geomodel {

/// Returns the index of the fault that a horizon names under throw_at. Throws Error{usage} if no surface has this name.
std::size_t throw_fault(const std::vector<TriangulatedSurface>& surfaces, const TriangulatedSurface& horizon,
                        const std::string& name);

/// Assigns the triangles of horizon `s` to blocks and extends each block. Faults across which a connected part of the
/// horizon continues do not divide it. If the triangles that cross faults cannot be replaced, the horizon is divided
/// only at faults through the whole model, or is left unchanged, with warnings. Sets the horizon's entries in
/// `built.rows`.
void build_blocks(BuiltSurfaces& built, std::size_t s, const ModelRules& rules, const BuildLog& log);

}  // namespace geomesh::geomodel
