// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Closes thin voids between surfaces: closed spaces that are thinner than the merging distance.
#pragma once

#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

struct ClosedPockets {
  std::size_t n_pockets = 0, n_facets_removed = 0;
  Displacement moved;  ///< movement of the corners of removed walls to the kept walls of their thin voids
};

/// Closes thin voids. A thin void is a closed space whose two walls are proven to be within the distance of each other.
/// One wall is removed, and the other becomes part of the surfaces of both. No new crossings arise, since no facet
/// moves. A void is kept if a wall is a side of the volume (surfaces from index `first_side` on), if something else is
/// attached to the wall, or if no part of one surface is about half of the void's area. A surface that then remains
/// only on a narrow strip between two voids is a dangling face there (cut_dangling_faces()). `parts` is as in
/// ArrangementOptions. Precondition: facets meet in shared vertices and edges only. Unused points may be left.
/// O(n log n) for voids of few facets.
ClosedPockets close_pockets(Complex& complex, double distance, Index first_side,
                            const std::vector<std::vector<Index>>& parts = {});

}  // namespace geomesh::geomodel::arrangement
