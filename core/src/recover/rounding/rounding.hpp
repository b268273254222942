// SPDX-License-Identifier: MIT
/// @file
/// Rounds the remaining Steiner points with exact places to doubles, one by one, each with an exact check of its star.
#pragma once

#include "recover/model/recover.hpp"

namespace geomesh::recover {

/// Rounds all exact points of the mesh to doubles and keeps every cell positive. Points are first moved along their
/// segments, in the planes of their facets or inside regions, to where their stars are thickest. Returns the points
/// that no double near them can replace; they remain exact.
std::vector<VertexIndex> round_exact_points(Recovery& recovery);

/// Moves those points of `left` that are inside regions to any doubles from which all of their link is visible, however
/// thin their stars are. Points without such a double remain in `left`, unchanged.
void round_anywhere_in_stars(Recovery& recovery, std::vector<VertexIndex>& left);

}  // namespace geomesh::recover
