// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Horizons given block by block: each block is continued on its own, through the faults that bound it.
#pragma once

#include <vector>

#include "build/extend.hpp"

namespace geomesh::geomodel {

/// The block of each triangle, from 0 in the order of their first triangles: sheets that lie, for most of their area, on the same sides
/// of all `faults` are one block. Which side is that of the nearest fault triangle's plane; it only sorts sheets, nothing is cut by it.
std::vector<Index> sort_into_blocks(const TriangulatedSurface& horizon, const std::vector<const TriangulatedSurface*>& faults);

/// Continues each block to beyond the box as extend_to_box does; `block` grows with the triangles. The blocks then run through each
/// other; trim_soup ends them at the faults.
void extend_blocks(TriangulatedSurface& horizon, std::vector<Index>& block, Extend how, const Box3& box, const BuildLog& log);

}  // namespace geomesh::geomodel
