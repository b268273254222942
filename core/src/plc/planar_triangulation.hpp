// SPDX-License-Identifier: MIT
/// @file
/// A constrained Delaunay triangulation in a plane given by projected coordinates; small, for facets.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh {

/// Triangles as a map from directed edges to apexes: (a,b) -> c for the counter-clockwise triangle a,b,c.
class PlanarTriangulation {
 public:
  /// inside_circle(a,b,c,d): d is inside the circle of a,b,c, never tied; local vertex numbers.
  using CircleTest = std::function<bool(unsigned, unsigned, unsigned, unsigned)>;

  PlanarTriangulation(std::vector<Vec2> points, CircleTest inside_circle)
      : points_(std::move(points)), inside_circle_(std::move(inside_circle)) {}

  /// Delaunay triangulation of all points. False where all are collinear or two are equal.
  bool triangulate();
  /// What stands in the way of a constraint: a vertex on it or a constraint that it crosses.
  using Obstacle = std::vector<unsigned>;
  /// Makes a-b an edge for good, by flips. An obstacle: not done.
  std::optional<Obstacle> insert_constraint(unsigned a, unsigned b);
  /// The Delaunay criterion for all edges that are no constraints.
  void restore_delaunay();
  bool is_constraint(unsigned a, unsigned b) const { return constraints_.count(key(a, b)) > 0; }
  std::optional<unsigned> apex(unsigned a, unsigned b) const;
  const std::map<std::array<unsigned, 2>, unsigned>& directed_edges() const { return apex_; }

 private:
  using Edge = std::array<unsigned, 2>;
  static Edge key(unsigned a, unsigned b) { return a < b ? Edge{a, b} : Edge{b, a}; }
  Sign orient(unsigned a, unsigned b, unsigned c) const;
  void add(unsigned a, unsigned b, unsigned c);
  void flip(unsigned a, unsigned b);
  bool flippable(unsigned a, unsigned b) const;
  std::optional<Obstacle> crossed_edges(unsigned a, unsigned b, std::vector<Edge>& out) const;

  std::vector<Vec2> points_;
  CircleTest inside_circle_;
  std::map<Edge, unsigned> apex_;
  std::set<Edge> constraints_;
};

}  // namespace geomesh
