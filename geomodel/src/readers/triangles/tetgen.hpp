// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The pieces of a TetGen facet: polygons and hole points of one plane as facets with holes, inner segments and inner
/// points.
#pragma once

#include <array>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// One facet of a .poly file as it stands there.
struct TetgenFacet {
  std::vector<std::vector<VertexIndex>> polygons;  ///< one vertex: a point; two: a segment; more: closed
  std::vector<Vec3> holes;
};

/// A connected part of a facet's plane: outer boundary, holes, and what lies inside.
struct FacetPiece {
  std::vector<std::vector<VertexIndex>> loops;  ///< outer boundary first
  std::vector<std::array<VertexIndex, 2>> segments;
  std::vector<VertexIndex> points;
};

/// A closed polygon with a hole point directly in it is a hole of the polygon around it. What lies in that hole is a
/// piece of its own. A closed polygon without one divides its surroundings by its segments. Containment is decided
/// exactly in the plane of two axes.
std::vector<FacetPiece> facet_pieces(const std::vector<Vec3>& points, const TetgenFacet& facet);

}  // namespace geomesh::geomodel
