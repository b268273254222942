// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Makes aprons: strips of triangles that continue a surface from a run of its border to its bounding surfaces.
#pragma once

#include <vector>

#include "rules/continuation/border_chains.hpp"

namespace geomesh::geomodel {

/// A strip of triangles beside a run of border edges of a surface. Indices of points count those of the surface first,
/// then `added`.
struct Apron {
  std::vector<Vec3> added;
  std::vector<Triangle> triangles;  ///< triangles of the strip, oriented as the surface at its border
  std::vector<Index> side;          ///< for each triangle: the side of bounding surfaces from which its heights come
  std::vector<Index> walls;         ///< indices of the surfaces that the strip of triangles crosses, ascending
  bool crosses_itself = false;  ///< whether the continued border crosses itself in the plane; the strip is then empty
};

/// The plane in which an apron (the strip of triangles beside a run of border) has one height at each place: the map
/// for horizons and the mean plane for faults. Also the distance over which the apron extends.
struct ApronSetting {
  Frame frame;
  double within = 0;  ///< m
  Box3 bounds;        ///< of the model
};

/// Makes an apron, the strip of triangles beside a run of border edges, by a constrained Delaunay triangulation of the
/// border and of a grid beside it. Heights are those of the nearest point of the border that no bounding surface hides,
/// extrapolated with the border's slope there. A triangle that a bounding surface divides is added once for each side;
/// each copy extends the heights of its own side to all three corners. Both sides are connected around the end of a
/// bounding surface. Places that a bounding surface hides from the border are left out, except in these triangles and
/// those next to them; so are places where no bounding surface stops the surface within the distance. Empty if the
/// border crosses itself in the plane. O(n log n) in edges and grid points.
Apron make_apron(const TriangulatedSurface& surface, Index row, const BorderChain& chain, const Walls& walls,
                 const ApronSetting& setting);

}  // namespace geomesh::geomodel
