// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// On which side of a horizon most of a piece of another one lies, by heights.
#pragma once

#include <optional>

#include "rules/planar/map_locator.hpp"
#include "rules/planar/pieces.hpp"

namespace geomesh::geomodel {

/// A piece may go on beyond the end of the horizon that cuts it, and meet it again from its other side. Edges where
/// they meet tell little of such a piece; the area above and below tells its side.
class HeightVote {
 public:
  /// What is left of surface y.
  HeightVote(const WorkingSoup& working, Index y);
  HeightVote(const HeightVote&) = delete;
  HeightVote& operator=(const HeightVote&) = delete;

  /// 1: most of the piece's area lies above y, -1: below, 0: y is over or under none of it. Facets are judged at their
  /// centres, exactly, where y is there once.
  int side_of(const Piece& piece) const;

 private:
  const WorkingSoup& working_;
  TriangulatedSurface left_;
  std::optional<MapLocator> locator_;
};

}  // namespace geomesh::geomodel
