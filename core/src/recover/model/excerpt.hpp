// SPDX-License-Identifier: MIT
/// @file
/// Extracts the part of a mesh around the place where recovery ended, for viewing.
#pragma once

#include <memory>
#include <span>

#include "recover/model/recover.hpp"

namespace geomesh::recover {

/// Returns the finite cells within two steps of these vertices, and the declared segments and facets whose vertices all
/// belong to these cells. If there are more than `max_cells` cells, those with the fewest steps are taken. O(returned
/// cells + declared constraints).
std::shared_ptr<const MeshExcerpt> excerpt_about(const Recovery& recovery, std::span<const VertexIndex> vertices,
                                                 std::size_t max_cells = 4000);

}  // namespace geomesh::recover
