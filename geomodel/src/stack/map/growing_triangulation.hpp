// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A constrained Delaunay triangulation of a convex part of the map, into which points are inserted one at a time.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rules/planar/planar_lines.hpp"

namespace geomesh::geomodel {

/// A growing constrained Delaunay triangulation. Cells are counter-clockwise triangles; side i is opposite vertex i.
/// New edges never cross the constraint lines or the rim.
class GrowingTriangulation {
 public:
  struct Cell {
    Triangle vertices;
    std::array<Index, 3> neighbours;  ///< neighbouring cell across each side, no_index beyond the rim
    std::array<bool, 3> lined;        ///< whether each side of the cell is part of a constraint line or of the rim
    Index zone;  ///< number of the cell's zone; new cells inherit it from the cells that they replace
  };
  /// Numbers the zones from 0: maximal sets of cells connected across sides that are not on constraint lines.
  explicit GrowingTriangulation(const LinedTriangulation& start);

  const std::vector<Vec2>& points() const { return points_; }
  const std::vector<Cell>& cells() const { return cells_; }
  std::size_t n_zones() const { return n_zones_; }

  /// Returns the triangulation's cell that contains p, found by a walk from `hint`; no_index outside its rim.
  Index locate(const Vec2& p, Index hint) const;
  /// Walks the straight line from p, in cell `at`, to q and calls f(cell, first vertex, second vertex of the crossed
  /// side, fraction of the line) for each cell that it leaves.
  template <class F>
  void walk(const Vec2& p, Index at, const Vec2& q, F&& f) const;
  /// Sets `cells` to the cells around a vertex, in no particular order.
  void star(VertexIndex v, std::vector<Index>& cells) const;

  /// The changes to the triangulation's cells by the insertion of one point.
  struct Change {
    VertexIndex vertex = no_vertex;  ///< the inserted vertex; no_vertex if nothing was inserted
    std::vector<Index> emptied;      ///< indices of the triangulation's removed cells; new cells reuse them
    std::vector<Index> made;
  };
  /// Inserts p inside cell `at`, or on a side of it. If p lies in the diametral circle of a constraint segment longer
  /// than `shortest`, that segment is split at its midpoint instead. Inserts nothing that is closer than a quarter of
  /// `shortest` to a vertex or constraint line.
  void add(const Vec2& p, Index at, double shortest, Change& change);

 private:
  void number_zones();
  void grow_cavity(const Vec2& p, Index at, Change& change);
  void halve(Index cell, std::size_t side, Change& change);
  bool is_crowded(const Vec2& p, double distance, const Change& change) const;
  /// Fills the cavity with cells around p. `halved`, if not empty, has the ends of the constraint segment with midpoint
  /// p.
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
    for (std::size_t i = 0; i < 3; ++i) {  // finds the side through which the line from p to q leaves the cell
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
