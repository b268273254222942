// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Makes aprons: strips of triangles that continue a surface from a run of its border to its bounding surfaces.
#pragma once

#include <vector>

#include "rules/continuation/border_chains.hpp"

namespace geomesh::geomodel {

/// Triangles beside a run of border. Their corners index the surface's points, followed by those of `added`.
struct Apron {
  std::vector<Vec3> added;
  std::vector<Triangle> triangles;  ///< triangles, oriented as the surface's triangle at the border
  std::vector<Index> side;          ///< for each triangle: number of the bounding surfaces' side that it continues
  std::vector<Index> walls;         ///< indices of the surfaces that the apron crosses, ascending
  bool crosses_itself = false;  ///< whether the run of border crosses itself in the plane, so that the apron is empty
};

/// The plane in which an apron (the strip of triangles beside a run of border) has one height at each place: the map
/// for horizons and the mean plane for faults. Also the distance over which the apron extends.
struct ApronSetting {
  Frame frame;
  double within = 0;  ///< m
  Box3 bounds;        ///< of the model
};

/// Makes an apron, the strip of triangles beside a run of border, by a constrained Delaunay triangulation of the border
/// and of a grid beside it. Its height is that of the nearest point of the border that no bounding surface hides,
/// extrapolated with the border's slope there. A triangle that a bounding surface divides is added once for each side,
/// with the heights of that side on both sides of the bounding surface; both sides are connected around the end of a
/// bounding surface. Places that a bounding surface hides from the border are left out, except in these triangles and
/// those next to them. Places where no bounding surface stops the surface within the distance are left out, too. Empty
/// if the run of border crosses itself in the plane. O(n log n) in the edges of the border and the points of the grid.
Apron make_apron(const TriangulatedSurface& surface, Index row, const BorderChain& chain, const Walls& walls,
                 const ApronSetting& setting);

}  // namespace geomesh::geomodel
