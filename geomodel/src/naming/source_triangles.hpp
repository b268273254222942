// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds the input triangles that mesh faces represent.
#pragma once

#include <map>
#include <vector>

#include "geomesh/core/surface_distance.hpp"
#include "geomesh/geomodel/build_model.hpp"

namespace geomesh::geomodel {

/// Finds input triangles of the first surface to which a facet belongs, from the origins stored in the polygon soup. A
/// facet may consist of several soup facets (polygons on sides of the box). It may also reach beyond its input
/// triangle: where two surfaces were merged, a facet of one lies along several triangles of the other. Then the nearest
/// triangle is returned. A polygon that was read from a file counts as one triangle.
class SourceTriangles {
 public:
  /// `meshed` outlives this.
  explicit SourceTriangles(const MeshedModel& meshed) : meshed_(meshed) {}

  /// Returns the input triangle of the facet at its point p. O(1), or O(log n) if another triangle is nearer.
  Index of(Index facet, const Vec3& p);

 private:
  /// For a facet that consists of several coplanar soup facets, returns the one that contains p or is nearest to it.
  Index under(const Vec3& p, Index facet);
  std::vector<Index> triangles_of(Index facet) const;
  double distance_from(const Vec3& p, Index surface, Index triangle) const;
  const SurfaceDistance& search_in(Index surface);

  const MeshedModel& meshed_;
  std::map<Index, std::vector<Index>> candidates_;  ///< by facet
  /// For each surface, the search structure for distances from it, made at its first use.
  std::map<Index, SurfaceDistance> searches_;
};

}  // namespace geomesh::geomodel
