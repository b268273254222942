// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Sums up the reports of the blocks in which a stack was settled.
#pragma once

#include "geomesh/geomodel/stack.hpp"

namespace geomesh::geomodel {

/// Adds what was settled in one block to the whole: areas, volumes and islands are summed, the largest moves stay, and
/// maps of thickness are laid over each other. Horizons and units are known by their names.
void merge_told(const SettledStack& block, SettledStack& whole);

}  // namespace geomesh::geomodel
