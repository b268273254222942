// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A horizon with throw, made into blocks that end at its faults.
#pragma once

#include <string>
#include <vector>

#include "rules/extend/extend.hpp"

namespace geomesh::geomodel {

/// Row of the fault that a horizon names under throw_at. Throws Error{usage} where no surface has the name.
std::size_t throw_fault(const std::vector<TriangulatedSurface>& surfaces, const TriangulatedSurface& horizon,
                        const std::string& name);

/// Row `s`: the horizon sorted into blocks, each continued on its own. Faults that a sheet runs on across do not part
/// it. Where what crosses the faults cannot be made anew, it is parted at those that go through the model alone, or
/// stays as given. Warnings tell. Sets the horizon's rows in `built.rows`.
void build_blocks(BuiltSurfaces& built, std::size_t s, const ModelRules& rules, const BuildLog& log);

}  // namespace geomesh::geomodel
