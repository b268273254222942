// SPDX-License-Identifier: MIT
/// @file
/// Steiner points that are left at exact places become doubles, one by one, each with an exact check of its star.
#pragma once

#include "recover/model/recover.hpp"

namespace geomesh::recover {

/// Every vertex of the mesh is a double afterwards, and every cell is positive. Points are first moved along their
/// segments, in their facets' planes or inside, to where their stars are thickest. Points that no double near them does
/// for are returned; they are exact as before.
std::vector<VertexIndex> round_exact_points(Recovery& recovery);

/// Points of `left` inside regions take any double that their whole stars see, however thin these are. What none does
/// for stays in `left`, as it is.
void round_anywhere_in_stars(Recovery& recovery, std::vector<VertexIndex>& left);

}  // namespace geomesh::recover
