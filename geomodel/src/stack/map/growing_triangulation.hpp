// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A constrained Delaunay triangulation of a convex piece of the map that points are added to, one at a time.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rules/planar/planar_lines.hpp"

namespace geomesh::geomodel {

/// Triangles are counter-clockwise; side i is opposite to vertex i. Lines, and the rim, are never crossed by a new
/// edge.
class GrowingTriangulation {
 public:
  struct Cell {
    Triangle vertices;
    std::array<Index, 3> neighbours;  ///< no_index beyond the rim
    std::array<bool, 3> lined;        ///< the side is part of a line or of the rim
    Index zone;                       ///< cells made from a cell keep its number
  };
  /// Zones are numbered from 0: maximal sets of cells joined across sides that are part of no line.
  explicit GrowingTriangulation(const LinedTriangulation& start);

  const std::vector<Vec2>& points() const { return points_; }
  const std::vector<Cell>& cells() const { return cells_; }
  std::size_t n_zones() const { return n_zones_; }

  /// The cell that holds p, by a walk from `hint`; no_index outside of the rim.
  Index locate(const Vec2& p, Index hint) const;
  /// Where the straight way from p, in cell `at`, to q leaves cells: calls f(cell, first vertex, second vertex of the
  /// side, share of the way) for each.
  template <class F>
  void walk(const Vec2& p, Index at, const Vec2& q, F&& f) const;
  /// Cells about a vertex, in no particular order.
  void star(VertexIndex v, std::vector<Index>& cells) const;

  /// What one addition changed.
  struct Change {
    VertexIndex vertex = no_vertex;  ///< no_vertex: nothing was added
    std::vector<Index> emptied;      ///< former cells; the new ones take their rows first
    std::vector<Index> made;
  };
  /// Adds p inside cell `at`, or on a side of it. Where p would come into the diametral circle of a line's piece longer
  /// than `shortest`, that piece is halved instead: the new vertex is its middle. Adds nothing nearer
  /// than a quarter of `shortest` to a vertex or line.
  void add(const Vec2& p, Index at, double shortest, Change& change);

 private:
  void number_zones();
  void grow_cavity(const Vec2& p, Index at, Change& change);
  void halve(Index cell, std::size_t side, Change& change);
  bool is_crowded(const Vec2& p, double distance, const Change& change) const;
  /// `halved`: the ends of the line's piece of which p is the middle, or nothing.
  void fill(const Vec2& p, std::span<const VertexIndex> halved, Change& change);
  bool is_in(Index cell) const { return epoch_of_[cell] == epoch_; }

  std::vector<Vec2> points_;
  std::vector<Cell> cells_;
  std::vector<Index> cell_of_vertex_;
  std::vector<Index> epoch_of_;
  Index epoch_ = 0;
  std::size_t n_zones_ = 0;
};

template <class F>
void GrowingTriangulation::walk(const Vec2& p, Index at, const Vec2& q, F&& f) const {
  const auto turn = [](const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  };
  double done = -1;
  for (std::size_t step = 0; at != no_index && step < cells_.size(); ++step) {
    const Cell& cell = cells_[at];
    double nearest = 2;
    std::size_t side = 3;
    for (std::size_t i = 0; i < 3; ++i) {  // of the sides that q is beyond, the first on the way
      const Vec2 &a = points_[cell.vertices[(i + 1) % 3]], &b = points_[cell.vertices[(i + 2) % 3]];
      const double to_p = turn(a, b, p), to_q = turn(a, b, q);
      if (!(to_q < 0)) continue;
      const double t = to_p / (to_p - to_q);
      if (t > done && t < nearest) nearest = t, side = i;
    }
    if (side == 3) return;
    f(at, cell.vertices[(side + 1) % 3], cell.vertices[(side + 2) % 3], nearest < 0 ? 0 : nearest);
    done = nearest;
    at = cell.neighbours[side];
  }
}

}  // namespace geomesh::geomodel
