// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Where triangles cross a fault, and where its continuation beyond the end that it has inside the model.
#pragma once

#include <vector>

#include "rules/throw_blocks.hpp"

namespace geomesh::geomodel {

/// What a triangle crosses: nothing, a fault as it is, or the continuation of one (which wins over the fault itself:
/// the fault ends in that triangle).
enum class Crossing : std::uint8_t { none, fault, continuation };

/// Of the horizon's triangles from row `first` on; by exact orientation of edges against triangles. Continuations count
/// inside the box.
std::vector<Crossing> find_crossings(const TriangulatedSurface& horizon, std::size_t first,
                                     const std::vector<ThrowFault>& faults, const Box3& box);

/// Continues a fault that ends inside the box to beyond it and gives the row of the first triangle made; leaves one
/// that does not as it is and gives its number of triangles. The continuation parts blocks from each other and is
/// removed from the model afterwards.
Index continue_fault(TriangulatedSurface& fault, const Box3& box);

}  // namespace geomesh::geomodel
