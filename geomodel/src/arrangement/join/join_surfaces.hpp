// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Merges surfaces that coincide up to rounding over their whole extent, and surfaces that end within rounding of
/// others.
#pragma once

#include <optional>

#include "arrangement/snap/snap.hpp"

namespace geomesh::geomodel::arrangement {

/// The merging distance, and the surfaces that are sides of the volume: those from index `first_side` on. Sides of a
/// volume that is not a box are never merged.
struct Joining {
  double distance = 0;
  std::optional<Box3> box;
  std::size_t first_side = 0;
  bool sides_are_fixed = false;
};

/// Merges surfaces that still cross after rounding, which therefore nearly coincide, wherever they are within the
/// distance. Mending them at the crossings alone would leave voids and gaps as thin as rounding between them. Sides of
/// a box keep their planes. Returns nothing if nothing was near enough. Cost: that of snap_near().
std::optional<SnapOutcome> join_what_lies_in_each_other(Complex& complex, const Contacts& contacts,
                                                        const Joining& joining);

/// Joins a surface that ends within the distance of another one to it, because after rounding its end would lie partly
/// in front of and partly beyond the other. The free edges and the facets near them take part, except for edges of
/// sides and edges on the box's planes or beyond. `vertex_now` is as for snap_near(). Returns nothing if nothing was
/// near enough. O(n log n) in the number of free edges, O(n) in that of facets, and the cost of snap_near() for the
/// facets that take part.
std::optional<SnapOutcome> join_ends(Complex& complex, const Joining& joining, std::vector<VertexIndex>& vertex_now);

}  // namespace geomesh::geomodel::arrangement
