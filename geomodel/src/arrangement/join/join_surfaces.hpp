// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Merges surfaces that coincide up to rounding over their whole extent, and surfaces that end within rounding of
/// others.
#pragma once

#include <optional>

#include "arrangement/snap/snap.hpp"

namespace geomesh::geomodel::arrangement {

/// The merging distance, and which surfaces are sides of the volume: rows from `first_side` on. Sides of a volume that
/// is not a box are never joined.
struct Joining {
  double distance = 0;
  std::optional<Box3> box;
  std::size_t first_side = 0;
  bool sides_are_fixed = false;
};

/// Surfaces that still cross once they are rounded nearly coincide somewhere. They are merged wherever they are within
/// the distance. If they were mended at the crossings alone, voids and gaps as thin as rounding would remain between
/// them. Sides of a box keep their planes. Returns nothing if nothing was near enough. Cost: that of snap_near.
std::optional<SnapOutcome> join_what_lies_in_each_other(Complex& complex, const Contacts& contacts,
                                                        const Joining& joining);

/// Joins a surface that ends within the distance of another one to it, because rounded ends would lie partly before and
/// partly beyond the other. Ends take part, and the facets to which they come close. Ends beyond the box, on its
/// planes, and those of sides do not. `vertex_now` is as from snap_near(). Returns nothing if nothing was near enough.
/// O(n log n) in the number of ends, O(n) in that of facets, and the cost of snap_near for those that take part.
std::optional<SnapOutcome> join_ends(Complex& complex, const Joining& joining, std::vector<VertexIndex>& vertex_now);

}  // namespace geomesh::geomodel::arrangement
