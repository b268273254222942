// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The border of a horizon's part in a block, and the heights at which it is continued.
#pragma once

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "arrangement/search/bvh.hpp"
#include "rules/continuation/horizon_division.hpp"
#include "rules/planar/planar_fill.hpp"

namespace geomesh::geomodel {

/// The border edges of a sheet in the map, over its own points. Holds no references.
class SheetBorder {
 public:
  /// `sheet` contains triangles over the horizon's points. Slopes are extrapolated over at most `within`, in m. With
  /// `averages`, slopes are means of the sheet within that distance, instead of those of the triangle at the border.
  SheetBorder(const TriangulatedSurface& horizon, const HorizonDivision& division, const std::vector<Triangle>& sheet,
              double within, bool averages);

  const std::vector<Vec3>& points() const { return points_; }
  VertexIndex row(Index v) const { return rows_[v]; }  ///< of the horizon
  const std::vector<std::pair<Index, Index>>& edges() const { return constraints_; }
  /// Returns whether the horizon stops short of a wall at an edge of points a < b.
  bool is_end(const std::pair<Index, Index>& edge) const { return is_end_.contains(edge); }
  bool faces_up() const { return faces_up_; }

  struct Place {
    Vec3 at;            ///< the place, with the height that the border has there
    double distance;    ///< distance from the border in the map
    Vec2 slope;         ///< slope of the sheet at the nearest border; zero beyond `within`
    bool has_met_wall;  ///< whether the border has already met its wall there
    Vec3 inside;        ///< the centroid of the triangle at the nearest border
  };
  /// Returns the extrapolated place at p. O(log n + k) for the k edges up to about twice as far in the map as the
  /// nearest one, or as `within`.
  Place continued_at(const Vec2& p) const;
  /// Returns whether an edge meets the segment in the map. O(log n + k) for the k edges in its box.
  bool meets(const Vec2& from, const Vec2& to) const;

  /// For each triangle, returns whether it is kept, lies outside the sheet, and is connected, through kept triangles,
  /// with a place where the horizon stops short of a wall. Where the sheet ends because the horizon continues beyond a
  /// wall, there is nothing to continue. O(n log n).
  std::vector<bool> beside_border(const std::vector<PlanarTriangle>& all, const std::vector<bool>& is_kept) const;

 private:
  struct Edge {
    Index a, b;
    Vec2 slope;
    bool has_met_wall;
    Vec3 inside;
  };

  void index_edges();
  /// Returns the rows of the edges whose boxes in the map meet that of the two places, ascending.
  std::vector<Index> edges_between(const Vec2& low, const Vec2& high) const;
  Place continued_from(const std::vector<Index>& edges, const Vec2& p) const;

  double within_;
  std::vector<Vec3> points_;
  std::vector<VertexIndex> rows_;
  std::vector<std::pair<Index, Index>> constraints_;
  std::set<std::pair<Index, Index>> is_end_;
  std::vector<Edge> edges_;
  std::optional<arrangement::BoxTree> tree_;  ///< tree of the edges' boxes in the map
  std::vector<bool> has_met_wall_;            ///< for each point, whether all edges there have met their wall
  bool faces_up_ = true;
};

}  // namespace geomesh::geomodel
