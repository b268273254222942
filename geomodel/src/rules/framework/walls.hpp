// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The surfaces on which another surface may end, asked by straight ways in space.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "arrangement/search/bvh.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Triangles of the model volume's sides and of surfaces (faults, bodies, horizons). It refers to nothing: the
/// triangles are copied. Whether a way meets a triangle is decided by exact orientations.
class Walls {
 public:
  static constexpr Index side_of_volume = no_index;  ///< as Hit::surface

  struct Hit {
    Index surface = side_of_volume;  ///< row of the surface
    bool from_above = false;         ///< the way begins on the side to which the triangle's normal points
    double share = 0;                ///< of the way up to the hit, from 0 to 1
  };

  /// `rows`: which of the surfaces are walls. `sides`: of the model volume.
  Walls(const std::vector<TriangulatedSurface>& surfaces, const std::vector<Index>& rows,
        const std::vector<TriangulatedSurface>& sides);

  bool empty() const { return triangles_.empty(); }
  /// Whether the surface of this row is among them.
  bool holds(Index surface) const { return std::ranges::binary_search(rows_, surface); }
  /// The first wall on the way from a to b, other than surface `but_not`. Walls that hold a itself do not count where
  /// the way leaves them.
  std::optional<Hit> first_hit(const Vec3& a, const Vec3& b, Index but_not) const;
  /// Like first_hit, but ignores the sides of the model volume.
  std::optional<Hit> first_surface(const Vec3& a, const Vec3& b, Index but_not) const;

  /// Whether a wall meets the disc about `centre`, along four lines of the map that rise with `slope`. A wall that
  /// holds the centre counts.
  bool meets_disc(const Vec3& centre, double radius, const Vec2& slope, Index but_not) const;
  /// The ways from the centre of a disc to its rim along these lines.
  static std::array<Vec3, 4> lines_of_disc(double radius, const Vec2& slope);

  /// All surfaces that meet the way, ascending, without the sides of the model volume.
  std::vector<Index> surfaces_on(const Vec3& a, const Vec3& b) const;

 private:
  struct Wall {
    Vec3 a, b, c;
    Index surface;
  };
  /// Calls visit(hit) for each triangle that meets the way.
  template <class F>
  void for_each_hit(const Vec3& a, const Vec3& b, F&& visit) const;
  void add(const TriangulatedSurface& s, Index row, std::vector<Box3>& boxes);

  std::vector<Index> rows_;  ///< ascending
  std::vector<Wall> triangles_;
  std::unique_ptr<arrangement::BoxTree> tree_;
};

}  // namespace geomesh::geomodel
