// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines by heights on which side of one horizon most of a piece of another horizon lies.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "rules/planar/map_locator.hpp"
#include "rules/planar/pieces.hpp"

namespace geomesh::geomodel {

/// Decides by the area of a piece of a horizon above and below another horizon y. The edges where they meet say little:
/// the piece may continue beyond the end of y and meet y again from the other side.
class HeightVote {
 public:
  /// Compares a piece's height with those facets of horizon y that were not removed. Places from which a fault, as far
  /// as it was not removed, separates y are ignored.
  HeightVote(const WorkingSoup& working, Index y, const std::vector<TriangulatedSurface>& surfaces);
  HeightVote(const HeightVote&) = delete;
  HeightVote& operator=(const HeightVote&) = delete;

  /// Returns 1 if most of the piece's area lies above the horizon y, -1 if below, 0 if y is neither above nor below any
  /// of it. Facets are tested at their centres, exactly, where y has one height. If a fault passes between the centre
  /// and y, then y belongs to another, displaced block, and the place is ignored.
  int side_of(const Piece& piece) const;

 private:
  /// The facets of some surfaces that were not removed from the soup, with a locator in the map.
  class Left {
   public:
    Left(const WorkingSoup& working, const std::function<bool(Index facet)>& is_mine);
    Left(const Left&) = delete;
    Left& operator=(const Left&) = delete;
    const TriangulatedSurface& surface() const { return surface_; }
    const std::optional<MapLocator>& locator() const { return locator_; }

   private:
    TriangulatedSurface surface_;
    std::optional<MapLocator> locator_;  ///< map locator of the facets that were not removed; empty if none is left
  };
  bool is_fault_between(const Vec3& p, double height) const;

  const WorkingSoup& working_;
  Left y_, faults_;
};

}  // namespace geomesh::geomodel
