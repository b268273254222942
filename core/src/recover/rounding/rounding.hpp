// SPDX-License-Identifier: MIT
/// @file
/// Rounds the remaining Steiner points with exact places to doubles, one by one, each with an exact check of its star.
#pragma once

#include "recover/model/recover.hpp"

namespace geomesh::recover {

/// Every vertex of the mesh is a double afterwards, and every cell is positive. Points are first moved along their
/// segments, in their facets' planes or inside, to where their stars are thickest. Returns points that no double near
/// them can replace; they remain exact.
std::vector<VertexIndex> round_exact_points(Recovery& recovery);

/// Points of `left` inside regions are moved to any double from which their whole stars are visible, however thin these
/// are. Points without such a double remain in `left`, unchanged.
void round_anywhere_in_stars(Recovery& recovery, std::vector<VertexIndex>& left);

}  // namespace geomesh::recover
