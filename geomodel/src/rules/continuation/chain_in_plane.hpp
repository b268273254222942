// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A chain of border edges projected onto a plane: the nearest point on it, which side of it lies outside the surface,
/// and the height of the surface's continuation.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "rules/continuation/border_chains.hpp"

namespace geomesh::geomodel {

class ChainInPlane {
 public:
  /// Continues surfaces with the slopes of triangles at the border, averaged along the chain over `within` both ways.
  ChainInPlane(const TriangulatedSurface& surface, const BorderChain& chain, const Frame& frame, double within);

  struct Nearest {
    Index edge = no_index;
    double along = 0;  ///< position of the nearest point on the edge, from 0 to 1
    double distance = 0;
  };
  /// Returns the point of the border chain that is nearest to p, if it is no farther than twice `within`; farther
  /// points may or may not be found.
  std::optional<Nearest> nearest(const Vec2& p) const;
  /// Returns the point nearest to p on each edge of the chain, if it is no farther than `most`, nearest first; `most`
  /// must be at most twice `within`.
  std::vector<Nearest> all_near(const Vec2& p, double most) const;
  /// Returns whether p lies outside the surface beside the chain, as seen from its nearest point on the chain. False
  /// beyond an open end of the chain and beside edges that are not continued.
  bool is_outside(const Vec2& p, const Nearest& at) const;
  /// Returns the coordinates of a nearest point on the border chain, in the frame.
  Vec3 foot(const Nearest& at) const;
  double height(const Vec2& p, const Nearest& at) const;

  const std::vector<Vec3>& points() const { return points_; }  ///< vertices of the chain, in the frame of the plane
  std::size_t n_edges() const { return slopes_.size(); }
  double mean_edge() const;
  std::size_t end_of(std::size_t edge) const { return (edge + 1) % points_.size(); }

 private:
  void find_slopes(const TriangulatedSurface& surface, const BorderChain& chain, const Frame& frame);
  void smooth_slopes(double within);
  Nearest nearest_on(Index edge, const Vec2& p) const;
  std::pair<std::int64_t, std::int64_t> cell_of(const Vec2& p) const;
  double length(std::size_t edge) const;

  std::vector<Vec3> points_;
  std::vector<Vec2> slopes_, out_;     ///< for each edge of the chain: slope of the surface and outward unit vector
  std::vector<std::uint8_t> goes_on_;  ///< per edge
  bool closed_;
  double cell_;
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<Index>> edges_in_cell_;
};

}  // namespace geomesh::geomodel
