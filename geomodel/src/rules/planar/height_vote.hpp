// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines on which side of a horizon most of a piece of another horizon lies, by heights.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "rules/planar/map_locator.hpp"
#include "rules/planar/pieces.hpp"

namespace geomesh::geomodel {

/// A piece may continue beyond the end of the horizon that cuts it, and meet it again from the other side. Edges where
/// they meet say little about such a piece; its area above and below does.
class HeightVote {
 public:
  /// Uses the remaining parts of surface y, and of the faults among the surfaces.
  HeightVote(const WorkingSoup& working, Index y, const std::vector<TriangulatedSurface>& surfaces);
  HeightVote(const HeightVote&) = delete;
  HeightVote& operator=(const HeightVote&) = delete;

  /// Returns 1 if most of the piece's area lies above y, -1 if below, 0 if y is neither above nor below any of it.
  /// Facets are tested at their centres, exactly, where y is present once. Where a fault passes between the two, y
  /// belongs to another, displaced block, and that place is ignored.
  int side_of(const Piece& piece) const;

 private:
  /// The remaining parts of some surfaces, with a locator in the map.
  class Left {
   public:
    Left(const WorkingSoup& working, const std::function<bool(Index facet)>& is_mine);
    Left(const Left&) = delete;
    Left& operator=(const Left&) = delete;
    const TriangulatedSurface& surface() const { return surface_; }
    const std::optional<MapLocator>& locator() const { return locator_; }

   private:
    TriangulatedSurface surface_;
    std::optional<MapLocator> locator_;  ///< locator, if any parts remain
  };
  bool is_fault_between(const Vec3& p, double height) const;

  const WorkingSoup& working_;
  Left y_, faults_;
};

}  // namespace geomesh::geomodel
