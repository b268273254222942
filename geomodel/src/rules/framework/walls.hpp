// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Walls: surfaces on which another surface may end, with queries by straight segments.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "arrangement/search/bvh.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Walls: the surfaces (faults, bodies, horizons) and sides of the model volume on which another surface may end.
/// Copies their triangles, so it holds no references. Exact orientations decide whether a segment meets a triangle.
class Walls {
 public:
  static constexpr Index side_of_volume = no_index;  ///< as Hit::surface

  struct Hit {
    Index surface = side_of_volume;  ///< index of the surface that the segment hits
    bool from_above = false;         ///< whether the segment begins on the side to which the triangle's normal points
    double share = 0;                ///< fraction of the segment, from 0 to 1, at which it meets the surface
  };

  /// `rows` are the indices of the surfaces that are bounding surfaces. `sides` are the sides of the model volume.
  Walls(const std::vector<TriangulatedSurface>& surfaces, const std::vector<Index>& rows,
        const std::vector<TriangulatedSurface>& sides);

  bool empty() const { return triangles_.empty(); }
  /// Returns whether the surface with this index is a bounding surface.
  bool holds(Index surface) const { return std::ranges::binary_search(rows_, surface); }
  /// Returns the first bounding surface on the segment from a to b, ignoring surface `but_not`. Bounding surfaces that
  /// contain the point a do not count if the segment leaves them.
  std::optional<Hit> first_hit(const Vec3& a, const Vec3& b, Index but_not) const;
  /// Returns the first bounding surface on the segment from a to b, ignoring surface `but_not` and the sides of the
  /// model volume. Bounding surfaces that contain the point a do not count if the segment leaves them.
  std::optional<Hit> first_surface(const Vec3& a, const Vec3& b, Index but_not) const;

  /// Returns whether a bounding surface meets the disc around `centre`. Tested along four lines through the centre with
  /// the given slope; a bounding surface through the centre counts.
  bool meets_disc(const Vec3& centre, double radius, const Vec2& slope, Index but_not) const;
  /// Returns the four segments from the centre of a disc to its rim along which meets_disc() searches.
  static std::array<Vec3, 4> lines_of_disc(double radius, const Vec2& slope);

  /// Returns all bounding surfaces that meet the segment, ascending, without the sides of the model volume.
  std::vector<Index> surfaces_on(const Vec3& a, const Vec3& b) const;

 private:
  struct Wall {
    Vec3 a, b, c;
    Index surface;
  };
  /// Calls visit(hit) for each triangle of a bounding surface that meets the segment.
  template <class F>
  void for_each_hit(const Vec3& a, const Vec3& b, F&& visit) const;
  void add(const TriangulatedSurface& s, Index row, std::vector<Box3>& boxes);

  std::vector<Index> rows_;  ///< ascending
  std::vector<Wall> triangles_;
  std::unique_ptr<arrangement::BoxTree> tree_;
};

}  // namespace geomesh::geomodel
