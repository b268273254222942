// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Parts of a surface that run a little beyond a surface on which it is meant to end.
#pragma once

#include <string>
#include <vector>

#include "rules/planar/pieces.hpp"

namespace geomesh::geomodel {

/// Pieces of surface `s` that hang on `cutters` by one side, end freely and reach no further than `limit` (m) from the
/// cutters. A piece on which alone another surface of the soup ends is kept, as is the largest piece.
/// O(n log n) in the soup's edges, and O(n) for each piece that ends freely.
std::vector<Piece> overshoots_of(const WorkingSoup& working, Index s, const std::vector<Index>& cutters, double limit);

/// Takes these pieces off the soup; `note` tells of them. Returns the area, 0 where there are none.
double remove_overshoots(WorkingSoup& working, Index s, const std::vector<Index>& cutters, double limit,
                         const std::string& name, std::vector<std::string>& notes);

}  // namespace geomesh::geomodel
