// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds the two walls of a thin void, a closed space between surfaces.
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

/// Finds the wall of a thin void that can be removed from a complex. The complex must not change meanwhile.
class WallSearch {
 public:
  /// Surfaces from index `first_side` on are sides of the model volume.
  WallSearch(const Complex& complex, const EdgeFacets& edges, Index first_side);

  /// Returns the two walls of a shell (facet sides around a closed space): the removable part whose area is nearest to
  /// half of the shell's, and the rest. All facets of a part belong to the same surfaces. Returns nothing if no part
  /// has about half of the area, if other facets are attached to the part, or if it contains a side of the volume. O(n
  /// log n).
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
