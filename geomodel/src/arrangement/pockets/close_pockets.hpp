// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Closed spaces between surfaces that are thinner than the distance within which surfaces are brought together.
#pragma once

#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

struct ClosedPockets {
  std::size_t n_pockets = 0, n_facets_removed = 0;
  Displacement moved;  ///< of the corners of walls that went, to the walls that stay
};

/// A pocket is a closed space whose walls are proven to be within the distance of each other. One of its two walls
/// goes, and the other is then part of the surfaces of both. Where that leaves a surface on a strip alone, at which it
/// ends, it is no part of the strip. Nothing new can cross: facets go, and none moves. Pockets
/// stay of which a wall is a side of the volume: surfaces from the row `first_side` on are. So do those where something
/// else hangs on the wall, and those where no part of one surface is about half of the area.
/// `parts` as in ArrangementOptions.
/// Precondition: facets meet in shared vertices and edges only. Points that nothing names may be left. O(n log n) for
/// pockets of few facets.
ClosedPockets close_pockets(Complex& complex, double distance, Index first_side,
                            const std::vector<std::vector<Index>>& parts = {});

}  // namespace geomesh::geomodel::arrangement
