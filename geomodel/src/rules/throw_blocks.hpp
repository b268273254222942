// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Horizons given block by block: each block is continued on its own, through the faults that bound it.
#pragma once

#include <vector>

#include "rules/extend.hpp"

namespace geomesh::geomodel {

/// A fault across which a horizon has throw, and where its own continuation begins (its number of triangles where there
/// is none).
struct ThrowFault {
  const TriangulatedSurface* surface;
  Index first_made;
};

/// The block of each triangle, from 0 in the order of their first triangles: sheets that lie, for most of their area,
/// on the same sides of all `faults` are one block. Which side is that of the nearest fault triangle's plane; it only
/// sorts sheets, nothing is cut by it.
///
/// Where a fault ends inside the box, beyond its tip the horizon runs on. There its triangles belong to every block
/// (BuiltRows::of_every_block): those given that cross the fault's continuation. Where the sheets on both sides leave
/// a gap there, triangles that join them come too, which are appended to the horizon. What crosses the fault itself,
/// and what lies beyond it without going round its tip, is in no block (BuiltRows::of_no_block): the blocks are
/// continued to the fault in its place.
///
/// With `sheet`, one number per triangle, those of one number are a sheet; else those that hang together by edges.
/// Faults that end inside take no sheets from there.
std::vector<Index> sort_into_blocks(TriangulatedSurface& horizon, const std::vector<ThrowFault>& faults, Extend how,
                                    const Box3& box, const BuildLog& log, const std::vector<Index>& sheet = {});

/// Continues each block to beyond the box as extend_to_box does; `block` grows with the triangles. The blocks then run
/// through each other; trim_soup ends them at the faults.
void extend_blocks(TriangulatedSurface& horizon, std::vector<Index>& block, Extend how, const Box3& box,
                   const BuildLog& log);

}  // namespace geomesh::geomodel
