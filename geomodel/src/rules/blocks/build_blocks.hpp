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

/// Sets BuiltRows::parted_at and throw_blocks of a horizon, by its list under throw_at. Horizons with the same faults
/// share their blocks.
void set_throw_blocks(BuiltSurfaces& built, Index row, const ModelRules& rules);

/// Row `s`: the horizon sorted into the blocks of its faults, each of which is filled from its own data. Warnings tell
/// of faults that a sheet runs on across. Sets the horizon's rows in `built.rows`.
void build_blocks(BuiltSurfaces& built, std::size_t s, const ModelRules& rules, const BuildLog& log);

}  // namespace geomesh::geomodel
