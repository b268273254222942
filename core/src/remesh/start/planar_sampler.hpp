// SPDX-License-Identifier: MIT
/// @file
/// Places points inside a planar polygon at target distances from each other.
#pragma once

#include <functional>
#include <unordered_map>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::remesh {

/// Adds points to a polygon, from the border inwards. A point is accepted if no other point is closer than
/// `spacing_ratio` times the target size there, and no edge is closer than `edge_ratio` times this size. The second
/// rule is needed because a point beside the middle of a long edge is far from the ends of the edge.
class PlanarSampler {
 public:
  static constexpr double spacing_ratio = 0.75, edge_ratio = 0.4;
  /// A place and the target size there.
  struct Place {
    Vec2 at;
    double size;
  };
  /// A function that returns the size at p, given a place nearby at which the size is known.
  using SizeBeside = std::function<double(const Vec2& p, const Place& beside)>;
  /// The loops bound the polygon, with vertices at about the target distances; the outer loop is counter-clockwise.
  PlanarSampler(const std::vector<std::vector<Place>>& loops, SizeBeside size);
  /// Adds an existing point, or an inner segment with its ends, from which new points must keep their distance.
  void block(const Place& p) { add(p.at, p.size); }
  void block(const Place& a, const Place& b);
  /// Adds points inside the polygon, and returns them in the order in which they were accepted.
  std::vector<Vec2> run();

 private:
  struct Edge {
    Vec2 a, b;
    double size;  ///< at a
  };
  struct Seed {
    Place place;
    Vec2 direction;  ///< unit vector from `place` in which a new point is tried first
  };
  void add(const Vec2& p, double size);
  double along(const Vec2& p) const { return is_along_x_ ? p.x : p.y; }
  double across(const Vec2& p) const { return is_along_x_ ? p.y : p.x; }
  std::size_t row(double at) const;
  void enter(Index e, const Edge& edge, std::vector<std::vector<Index>>& rows) const;
  bool is_inside(const Vec2& p) const;
  bool is_clear_of(const std::vector<Edge>& edges, const std::vector<std::vector<Index>>& rows, const Vec2& p,
                   double radius) const;
  bool is_free(const Vec2& p, double size) const;
  bool take(const Vec2& p, const Place& from);
  void advance(unsigned n_directions, double distance);

  SizeBeside size_;
  std::vector<Edge> edges_, inner_edges_;
  /// Edges by strip; strips divide the longer dimension of the polygon, so a straight border along it is in all strips.
  std::vector<std::vector<Index>> rows_, inner_rows_;
  bool is_along_x_ = false;
  double low_ = 0, strip_ = 1;
  /// Points whose sizes are between two consecutive powers of two, in a grid with cells as wide as the larger power. A
  /// finer grid would have many cells.
  struct Level {
    int number;
    double cell;
    std::unordered_map<std::uint64_t, std::vector<Vec2>> cells;
  };
  std::vector<Level> levels_;  // ascending
  std::vector<Seed> seeds_;
  std::vector<Vec2> taken_;
};

}  // namespace geomesh::remesh
