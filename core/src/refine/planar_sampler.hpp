// SPDX-License-Identifier: MIT
/// @file
/// Points inside a polygon of the plane at asked distances from each other.
#pragma once

#include <functional>
#include <unordered_map>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::remesh {

/// Advances from the border inwards; a point is taken where none is nearer than `spacing_ratio` of the size asked there.
class PlanarSampler {
 public:
  static constexpr double spacing_ratio = 0.75;
  using Size = std::function<double(const Vec2&)>;
  /// Loops with vertices at about the asked distances, the outer one turning left, holes turning right.
  PlanarSampler(const std::vector<std::vector<Vec2>>& loops, Size size);
  /// A point that others keep away from: on an inner segment, say.
  void block(const Vec2& p) { add(p, size_(p)); }
  /// The points taken, in the order of taking.
  std::vector<Vec2> run();

 private:
  struct Edge {
    Vec2 a, b;
  };
  struct Seed {
    Vec2 at, direction;  ///< of length one: where the next point is tried first
  };
  void add(const Vec2& p, double size);
  bool is_inside(const Vec2& p) const;
  bool is_free(const Vec2& p, double size) const;
  bool take(const Vec2& p, const Vec2& from);
  void advance(unsigned n_directions, double distance);

  Size size_;
  std::vector<Edge> edges_;
  std::vector<std::vector<Index>> rows_;  // edges by strip in y
  double low_ = 0, strip_ = 1;
  std::unordered_map<std::uint64_t, std::vector<Vec2>> cells_;  // by level of size and place
  int least_level_ = 1000, greatest_level_ = -1000;
  std::vector<Seed> seeds_;
  std::vector<Vec2> taken_;
};

}  // namespace geomesh::remesh
