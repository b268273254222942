// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The triangles that faces of a mesh stand for.
#pragma once

#include <map>
#include <vector>

#include "geomesh/core/surface_distance.hpp"
#include "geomesh/geomodel/build_model.hpp"

namespace geomesh::geomodel {

/// Triangles of the first surface of a facet, as the soup's origins name them. A facet may stand for several soup
/// facets (polygons on box sides). It may reach beyond its triangle, too: where two surfaces were brought together, a
/// facet of one lies along several triangles of the other. Then the nearest triangle is told. A polygon of a file is
/// told by its row alone.
class SourceTriangles {
 public:
  /// `meshed` outlives this.
  explicit SourceTriangles(const MeshedModel& meshed) : meshed_(meshed) {}

  /// The triangle for the place p of the facet. O(1), O(log n) where another triangle is nearer.
  Index of(Index facet, const Vec3& p);

 private:
  /// Of a facet that stands for several soup facets: the one nearest to holding p, a point in their plane.
  Index under(const Vec3& p, Index facet);
  std::vector<Index> triangles_of(Index facet) const;
  double distance_from(const Vec3& p, Index surface, Index triangle) const;
  const SurfaceDistance& search_in(Index surface);

  const MeshedModel& meshed_;
  std::map<Index, std::vector<Index>> candidates_;  ///< by facet
  std::map<Index, SurfaceDistance> searches_;       ///< by surface, made when first asked for
};

}  // namespace geomesh::geomodel
