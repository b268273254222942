// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Which vertices, edges and facets lie nearer to each other than a distance. Lengths are rounded; nothing about
/// validity rests on them.
#pragma once

#include <functional>
#include <unordered_map>

#include "arrangement/snap/snap.hpp"

namespace geomesh::geomodel::arrangement {

/// The box planes that points lie on, as bits: 2 * axis for the minimum, 2 * axis + 1 for the maximum.
class BoxPlanes {
 public:
  explicit BoxPlanes(const std::optional<Box3>& box) : box_(box) {}
  unsigned of(const Vec3& p) const;
  /// p with its coordinates on those planes.
  Vec3 onto(Vec3 p, unsigned planes) const;
  /// p on the planes that it is nearer to than the distance, where it is not beyond the box by more.
  Vec3 onto_near(const Vec3& p, double distance) const;

 private:
  std::optional<Box3> box_;
};

/// Vertices by place.
class VertexGrid {
 public:
  VertexGrid(const std::vector<Vec3>& points, double distance) : points_(points), distance_(distance) {}
  void add(VertexIndex v) { cells_[cell_of(points_[v])].push_back(v); }
  /// The nearest vertex closer to p than the distance that lies on all of `planes` and may be taken, or no_vertex.
  VertexIndex nearest(const Vec3& p, unsigned planes, const BoxPlanes& box,
                      const std::function<bool(VertexIndex)>& may_take) const;

 private:
  Vec3 cell_of(const Vec3& p) const;
  const std::vector<Vec3>& points_;
  double distance_;
  std::unordered_map<Vec3, std::vector<VertexIndex>, PointHash> cells_;
};

/// Finds vertices near edges, edges near each other and vertices near facets, among the given facets, edges and
/// vertices, where the rule allows it. Edges near each other add vertices to the complex, to the grid and to the rule.
Insertions find_insertions(Complex& complex, const std::vector<Index>& facets, const std::vector<EdgeKey>& edges,
                           std::vector<VertexIndex> vertices, VertexGrid& grid, SnapOptions& options);

}  // namespace geomesh::geomodel::arrangement
