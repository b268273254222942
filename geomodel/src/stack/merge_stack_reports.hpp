// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Combines the reports of the blocks in which a stack was settled.
#pragma once

#include "geomesh/geomodel/stack.hpp"

namespace geomesh::geomodel {

/// Adds the report of one block to that of the whole: areas, volumes and islands are summed, the largest moves are
/// kept, and maps of thickness are combined. Horizons and units are matched by name.
void merge_stack_reports(const SettledStack& block, SettledStack& whole);

}  // namespace geomesh::geomodel
