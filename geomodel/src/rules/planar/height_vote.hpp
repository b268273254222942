// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// On which side of a horizon most of a piece of another one lies, by heights.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "rules/planar/map_locator.hpp"
#include "rules/planar/pieces.hpp"

namespace geomesh::geomodel {

/// A piece may go on beyond the end of the horizon that cuts it, and meet it again from its other side. Edges where
/// they meet tell little of such a piece; the area above and below tells its side.
class HeightVote {
 public:
  /// What is left of surface y, and of the faults among the surfaces.
  HeightVote(const WorkingSoup& working, Index y, const std::vector<TriangulatedSurface>& surfaces);
  HeightVote(const HeightVote&) = delete;
  HeightVote& operator=(const HeightVote&) = delete;

  /// 1: most of the piece's area lies above y, -1: below, 0: y is over or under none of it. Facets are judged at their
  /// centres, exactly, where y is there once. Where a fault passes between, y is that of another block, which was
  /// thrown: it tells nothing there.
  int side_of(const Piece& piece) const;

 private:
  /// What is left of some surfaces, and where in the map.
  class Left {
   public:
    Left(const WorkingSoup& working, const std::function<bool(Index facet)>& is_mine);
    Left(const Left&) = delete;
    Left& operator=(const Left&) = delete;
    const TriangulatedSurface& surface() const { return surface_; }
    const std::optional<MapLocator>& locator() const { return locator_; }

   private:
    TriangulatedSurface surface_;
    std::optional<MapLocator> locator_;  ///< where anything is left
  };
  bool is_fault_between(const Vec3& p, double height) const;

  const WorkingSoup& working_;
  Left y_, faults_;
};

}  // namespace geomesh::geomodel
