// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds the places over a fault block at which a horizon may be continued, and those that are open (not enclosed).
#pragma once

#include <array>
#include <optional>
#include <set>
#include <vector>

#include "rules/continuation/sheet_border.hpp"
#include "rules/framework/block_framework.hpp"
#include "rules/framework/walls.hpp"
#include "rules/planar/nearest_place.hpp"

namespace geomesh::geomodel {

/// A horizon, and the blocks and bounding surfaces of its continuation, as in BlockSetting. References must stay valid.
struct HorizonInBlocks {
  const TriangulatedSurface& horizon;
  Index row;
  const BlockFramework& framework;
  const Walls& cutters;  ///< faults and bodies that bound the blocks in which the horizon is continued
  const Walls& walls;
  double within;
  const HorizonDivision& division;
  bool fills_blocks, has_margin;
};

/// The places at which a connected part of a horizon may be continued: its border, followed by a grid over its block,
/// with heights extrapolated from the border.
class BlockPlaces {
 public:
  /// `sheet` is the connected part of the horizon that is continued, as triangles over the horizon's points.
  /// Construction takes O(m log n) for n edges of the border and m grid points near it.
  BlockPlaces(const HorizonInBlocks& setting, Index block, const std::vector<Triangle>& sheet);
  BlockPlaces(const BlockPlaces&) = delete;
  BlockPlaces& operator=(const BlockPlaces&) = delete;

  /// Returns false if the distance of continuation is too short for a grid, so that there are no grid points.
  bool has_grid() const;
  const SheetBorder& border() const { return border_; }
  const std::vector<Vec3>& points() const { return points_; }
  std::size_t n_border() const { return n_border_; }       ///< the first points
  double distance(Index v) const { return distance_[v]; }  ///< map distance in m of place v from the horizon's border
  /// Returns whether the place is in the block and may be filled. It may not where the surface already reaches a wall
  /// (bounding surface) before its border, or beyond another horizon, which ends the continuation as walls do.
  bool is_in_block(Index v) const { return in_block_[v]; }
  bool overlaps(const std::array<Index, 3>& t) const;
  /// Returns whether a triangle is added to the horizon's continuation: it reaches into the block, and no corner there
  /// lies in a gap too wide to be filled. If so, adds the bounding surfaces that it crosses to `walls`.
  bool is_filled(const std::array<Index, 3>& t, std::set<Index>& walls) const;

 private:
  void add_grid();
  void find_open_places();
  bool is_beyond_horizon(std::size_t v) const;
  bool ends_in_the_open(std::size_t v) const;
  bool is_open(Index v) const;

  HorizonInBlocks s_;
  Index block_;
  double radius_, step_;
  SheetBorder border_;
  std::vector<Vec3> points_;
  std::vector<double> distance_;
  std::vector<Vec2> slope_;
  std::vector<Vec3> inside_;  ///< per place: centroid of the horizon's triangle at the border edge nearest to it
  std::vector<bool> in_block_;
  std::size_t n_border_;
  std::vector<Vec3> open_;  ///< centres of discs
  std::optional<NearestPlace> nearest_open_;
};

}  // namespace geomesh::geomodel
