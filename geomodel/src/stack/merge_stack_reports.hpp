// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Combines the reports on the fault blocks in which a stack of horizons was put in order.
#pragma once

#include "geomesh/geomodel/stack.hpp"

namespace geomesh::geomodel {

/// Adds the report on one block to that on the whole model: areas, volumes and islands are summed, the largest moves
/// are kept, and maps of thickness are combined. Horizons and units are matched by name.
void merge_stack_reports(const SettledStack& block, SettledStack& whole);

}  // namespace geomesh::geomodel
