// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Facets split at the middles of their longest edges.
#pragma once

#include <functional>

#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

/// One round: facets that are asked for and have an edge longer than `longest` are split at the middle of their longest
/// edge, and so are those beside them, so that they meet in whole edges as before (Rivara 1984). Edges along which a
/// well may run stay, and so do those whose middle is the place of a point. Pieces have the origins of what they are
/// of. Gives whether anything was split. O(n log n).
bool bisect_facets(Complex& complex, double longest, const std::function<bool(Index)>& is_asked);

}  // namespace geomesh::geomodel::arrangement
