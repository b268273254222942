// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The strip by which a surface is continued from a run of its border to the walls in front of it.
#pragma once

#include <set>
#include <vector>

#include "rules/continuation/border_chains.hpp"

namespace geomesh::geomodel {

/// Triangles beside a run of border, over the rows of the surface's points followed by those of `added`.
struct Apron {
  std::vector<Vec3> added;
  std::vector<Triangle> triangles;  ///< triangles oriented as the surface's triangle at the border
  std::vector<Index> side;          ///< for each triangle, number from 0 of the side of walls that it continues
  std::vector<Index> walls;         ///< rows of the surfaces that the strip crosses, ascending
  bool crosses_itself = false;      ///< whether the run of border crosses itself in the plane, so that nothing was made
};

/// The plane in which an apron (the strip beside a run of border) has one height at each place, the map for horizons
/// and the mean plane for faults, and the distance over which it extends.
struct ApronSetting {
  Frame frame;
  double within = 0;  ///< m
  Box3 bounds;        ///< of the model
  /// Rows of the surface's points at which a wall ends: both of its sides begin there, and nothing else connects them.
  const std::set<VertexIndex>& tips;
};

/// The apron has the height of the nearest point of the border that no wall hides, extrapolated with the border's slope
/// there. It is a constrained Delaunay triangulation of the run of border and of a grid beside it. A triangle that a
/// wall divides is added once for each side, with the heights of that side beyond the wall too; both sides meet at the
/// tip of the wall. Places that a wall hides from the border are left out, except in these triangles and
/// those next to them, and so are places where no wall stops the surface within the distance. Empty if the run of
/// border crosses itself in the plane. O(n log n) in the edges of the run and the points of the grid.
Apron make_apron(const TriangulatedSurface& surface, Index row, const BorderChain& chain, const Walls& walls,
                 const ApronSetting& setting);

}  // namespace geomesh::geomodel
