// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds the two walls of a closed space.
#pragma once

#include <optional>
#include <vector>

#include "arrangement/pockets/shells.hpp"

namespace geomesh::geomodel::arrangement {

double area_of(const Complex& complex, const std::vector<FacetSide>& sides);

/// Both ascending.
struct PocketWalls {
  std::vector<FacetSide> that_goes, that_stays;
};

/// Looks for a wall that can be removed from a complex, which must not change meanwhile.
class WallSearch {
 public:
  /// Surfaces from the row `first_side` on are sides of the volume.
  WallSearch(const Complex& complex, const EdgeFacets& edges, Index first_side);

  /// Returns the part of one list of surfaces whose area is nearest to half of the shell, and the rest. Nothing if no
  /// part has about half, if something else is attached to it, or if a side of the volume is part of it. O(n log n) for
  /// n sides.
  std::optional<PocketWalls> of(const std::vector<FacetSide>& shell) const;

 private:
  std::vector<std::vector<FacetSide>> parts_of(const std::vector<FacetSide>& shell) const;
  bool can_go(const std::vector<FacetSide>& wall) const;
  bool is_free_inside(VertexIndex a, VertexIndex b) const;

  const Complex& complex_;
  const EdgeFacets& edges_;
  Index first_side_;
  std::vector<std::uint8_t> is_held_;  // for each point: whether a well or an isolated point is there
  std::vector<Index> n_facets_at_;     // per point
};

}  // namespace geomesh::geomodel::arrangement
