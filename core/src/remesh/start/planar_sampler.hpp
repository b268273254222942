// SPDX-License-Identifier: MIT
/// @file
/// Points inside a polygon of the plane at target distances from each other.
#pragma once

#include <functional>
#include <unordered_map>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::remesh {

/// Advances from the border inwards. A point is accepted if none is nearer than `spacing_ratio` of the target size
/// there, and no edge nearer than `edge_ratio` of it: a point in the middle of an edge longer than its target would be
/// far enough from its ends.
class PlanarSampler {
 public:
  static constexpr double spacing_ratio = 0.75, edge_ratio = 0.4;
  /// A place and the target size there.
  struct Place {
    Vec2 at;
    double size;
  };
  /// The size at p, given a place nearby where it is known.
  using SizeBeside = std::function<double(const Vec2& p, const Place& beside)>;
  /// Loops with vertices at about the target distances, the outer one counter-clockwise, holes clockwise.
  PlanarSampler(const std::vector<std::vector<Place>>& loops, SizeBeside size);
  /// A point, or an inner segment, that others keep away from.
  void block(const Place& p) { add(p.at, p.size); }
  void block(const Place& a, const Place& b);
  /// The points taken, in the order of taking.
  std::vector<Vec2> run();

 private:
  struct Edge {
    Vec2 a, b;
    double size;  ///< at a
  };
  struct Seed {
    Place place;
    Vec2 direction;  ///< of length one: where the next point is tried first
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
  /// Edges by strip across the longer way of the polygon: a straight border along it is in all of them.
  std::vector<std::vector<Index>> rows_, inner_rows_;
  bool is_along_x_ = false;
  double low_ = 0, strip_ = 1;
  /// Points of sizes from one power of two up to the next, in cells as large as the next: smaller ones would be many.
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
