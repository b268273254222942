// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The border of the part of a horizon in one block, and the heights at which it is continued.
#pragma once

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "arrangement/search/bvh.hpp"
#include "rules/continuation/horizon_division.hpp"
#include "rules/planar/planar_fill.hpp"

namespace geomesh::geomodel {

/// The border edges, in the map, of the part ("sheet") of a horizon in one block. Holds copies of its points.
class SheetBorder {
 public:
  /// `sheet` contains triangles over the horizon's points. Slopes are extrapolated over at most `within`, in m. With
  /// `averages`, slopes are means over triangles within that distance of the border.
  SheetBorder(const TriangulatedSurface& horizon, const HorizonDivision& division, const std::vector<Triangle>& sheet,
              double within, bool averages);

  const std::vector<Vec3>& points() const { return points_; }
  VertexIndex row(Index v) const { return rows_[v]; }  ///< of the horizon
  const std::vector<std::pair<Index, Index>>& edges() const { return constraints_; }
  /// Returns whether the horizon stops short of a bounding surface at the edge between points a < b.
  bool is_end(const std::pair<Index, Index>& edge) const { return is_end_.contains(edge); }
  bool faces_up() const { return faces_up_; }

  struct Place {
    Vec3 at;            ///< the place in the model, with the height extrapolated from the horizon's border
    double distance;    ///< distance in m of the place from the horizon's border, in the map
    Vec2 slope;         ///< slope of the horizon at the nearest border edge; zero if that is farther than `within`
    bool has_met_wall;  ///< whether the nearest border edge lies on or beyond a bounding surface
    Vec3 inside;        ///< centroid of the horizon's triangle at the border edge nearest to the place
  };
  /// Returns the place at p to which the horizon is continued. O(log n + k) for the k edges in the map up to about
  /// twice the distance of the nearest one, or of `within`.
  Place continued_at(const Vec2& p) const;
  /// Returns whether a border edge meets the segment in the map. O(log n + k) for k edges in its bounding box.
  bool meets(const Vec2& from, const Vec2& to) const;

  /// For each triangle of the map, returns whether `is_kept` is set, it lies outside the horizon's part, and such
  /// triangles connect it with a border edge that stops short of a bounding surface. Nothing is continued from edges at
  /// which the part ends only because the horizon continues beyond a bounding surface. O(n log n).
  std::vector<bool> beside_border(const std::vector<PlanarTriangle>& all, const std::vector<bool>& is_kept) const;

 private:
  struct Edge {
    Index a, b;
    Vec2 slope;
    bool has_met_wall;
    Vec3 inside;
  };

  void index_edges();
  /// Returns the indices of the border edges whose bounding boxes in the map meet the given box, ascending.
  std::vector<Index> edges_between(const Vec2& low, const Vec2& high) const;
  Place continued_from(const std::vector<Index>& edges, const Vec2& p) const;

  double within_;
  std::vector<Vec3> points_;
  std::vector<VertexIndex> rows_;
  std::vector<std::pair<Index, Index>> constraints_;
  std::set<std::pair<Index, Index>> is_end_;
  std::vector<Edge> edges_;
  std::optional<arrangement::BoxTree> tree_;  ///< search tree of the border edges' bounding boxes in the map
  std::vector<bool> has_met_wall_;            ///< whether all border edges at a point have met a bounding surface
  bool faces_up_ = true;
};

}  // namespace geomesh::geomodel
