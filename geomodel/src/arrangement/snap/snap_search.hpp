// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds vertices, edges and facets that are closer to each other than a distance. Lengths are rounded; no decision on
/// validity depends on them.
#pragma once

#include <array>
#include <functional>

#include "arrangement/snap/snap.hpp"

namespace geomesh::geomodel::arrangement {

/// Encodes the box planes on which points lie as bits: 2 * axis for the minimum, 2 * axis + 1 for the maximum.
class BoxPlanes {
 public:
  explicit BoxPlanes(const std::optional<Box3>& box) : box_(box) {}
  unsigned of(const Vec3& p) const;
  /// Returns p with its coordinates moved exactly onto the given planes of the box.
  Vec3 onto(Vec3 p, unsigned planes) const;
  /// Returns p moved to the box planes within the distance, unless p is outside the box by more than that.
  Vec3 onto_near(const Vec3& p, double distance) const;

 private:
  std::optional<Box3> box_;
};

/// Hash grid of vertices, with cells four search distances wide: a search meets one to eight cells, mostly two.
class VertexGrid {
 public:
  VertexGrid(const std::vector<Vec3>& points, double distance) : points_(points), distance_(distance) {}
  void add(VertexIndex v);
  /// Returns the nearest vertex that is closer to p than the distance, lies on all of `planes` and may be used, or
  /// no_vertex. Of equally near vertices it returns the one with the smallest index.
  VertexIndex nearest(const Vec3& p, unsigned planes, const BoxPlanes& box,
                      const std::function<bool(VertexIndex)>& may_take) const;

 private:
  using Cell = std::array<double, 3>;
  struct Slot {
    Cell cell;
    VertexIndex first = no_vertex;  ///< no_vertex: nothing here
  };
  Cell cell_of(const Vec3& p) const;
  std::size_t place_of(const Cell& cell) const;
  void grow();

  const std::vector<Vec3>& points_;
  double distance_;
  std::vector<Slot> slots_;        // hash table with linear probing; its size is a power of two
  std::vector<VertexIndex> next_;  // for each vertex: the next one in its cell of the hash grid
  std::size_t n_cells_ = 0;
};

/// Finds vertices to insert in the given facets and edges: those of the given vertices that are near an edge or a
/// facet, and new ones where two edges are near each other, if the join rule allows merging them. New vertices are
/// added to the complex, the grid and the rule.
Insertions find_insertions(Complex& complex, const std::vector<Index>& facets, const std::vector<EdgeKey>& edges,
                           std::vector<VertexIndex> vertices, VertexGrid& grid, SnapOptions& options);

}  // namespace geomesh::geomodel::arrangement
