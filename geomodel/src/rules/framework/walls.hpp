// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The surfaces on which another surface may end, with queries by straight segments.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "arrangement/search/bvh.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Triangles of the model volume's sides and of surfaces (faults, bodies, horizons). Holds no references, since the
/// triangles are copied. Whether a segment meets a triangle is decided by exact orientations.
class Walls {
 public:
  static constexpr Index side_of_volume = no_index;  ///< as Hit::surface

  struct Hit {
    Index surface = side_of_volume;  ///< row of the surface that was hit
    bool from_above = false;         ///< whether the segment begins on the side to which the triangle's normal points
    double share = 0;                ///< fraction of the segment up to the hit, from 0 to 1
  };

  /// `rows` selects the surfaces that are walls. `sides` are those of the model volume.
  Walls(const std::vector<TriangulatedSurface>& surfaces, const std::vector<Index>& rows,
        const std::vector<TriangulatedSurface>& sides);

  bool empty() const { return triangles_.empty(); }
  /// Returns whether the surface of this row is a wall.
  bool holds(Index surface) const { return std::ranges::binary_search(rows_, surface); }
  /// Returns the first wall on the segment from a to b, except surface `but_not`. Walls that contain a itself do not
  /// count if the segment leaves them.
  std::optional<Hit> first_hit(const Vec3& a, const Vec3& b, Index but_not) const;
  /// Like first_hit, but ignores the sides of the model volume.
  std::optional<Hit> first_surface(const Vec3& a, const Vec3& b, Index but_not) const;

  /// Returns whether a wall meets the disc around `centre`, tested along four lines that follow the slope. A wall
  /// through the centre counts.
  bool meets_disc(const Vec3& centre, double radius, const Vec2& slope, Index but_not) const;
  /// Returns the segments from the centre of a disc to its rim along these lines.
  static std::array<Vec3, 4> lines_of_disc(double radius, const Vec2& slope);

  /// Returns all surfaces that meet the segment, ascending, without the sides of the model volume.
  std::vector<Index> surfaces_on(const Vec3& a, const Vec3& b) const;

 private:
  struct Wall {
    Vec3 a, b, c;
    Index surface;
  };
  /// Calls visit(hit) for each triangle that meets the segment.
  template <class F>
  void for_each_hit(const Vec3& a, const Vec3& b, F&& visit) const;
  void add(const TriangulatedSurface& s, Index row, std::vector<Box3>& boxes);

  std::vector<Index> rows_;  ///< ascending
  std::vector<Wall> triangles_;
  std::unique_ptr<arrangement::BoxTree> tree_;
};

}  // namespace geomesh::geomodel
