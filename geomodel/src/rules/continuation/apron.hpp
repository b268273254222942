// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The strip by which a surface goes on from a run of its border to the walls before it.
#pragma once

#include <vector>

#include "rules/continuation/border_chains.hpp"

namespace geomesh::geomodel {

/// Triangles beside a chain, over rows of the surface's points and of `added` after them.
struct Apron {
  std::vector<Vec3> added;
  std::vector<Triangle> triangles;  ///< oriented as the surface's triangle at the border
  std::vector<Index> side;          ///< per triangle, from 0: which of the sides of walls it continues
  std::vector<Index> walls;         ///< surfaces that it runs through, ascending
  bool crosses_itself = false;      ///< the chain in the plane, so nothing was made
};

/// Where an apron is made: the plane in which it has one height at a place (the map for horizons, the mean plane for
/// faults), and how far it goes.
struct ApronSetting {
  Frame frame;
  double within = 0;  ///< m
  Box3 bounds;        ///< of the model
};

/// The apron has the height of the nearest point of the border that no wall hides, continued with the border's slope
/// there. It is a constrained Delaunay triangulation of the chain and of a grid beside it. A triangle that a wall parts
/// comes once for each side, with the heights of that side beyond the wall too; round the end of a wall both sides are
/// one. What the border does not see for a wall is left out but for these triangles and those next to them, and so is
/// what no wall stops within the distance. Empty where the chain crosses
/// itself in the plane. O(n log n) in the chain's edges and the grid's points.
Apron make_apron(const TriangulatedSurface& surface, Index row, const BorderChain& chain, const Walls& walls,
                 const ApronSetting& setting);

}  // namespace geomesh::geomodel
