// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Divides a TetGen facet into pieces: its polygons and hole points in one plane become facets with holes, inner
/// segments and inner points.
#pragma once

#include <array>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

struct TetgenFacet {
  /// Vertices of each polygon of the facet: one for an isolated point, two for a segment, more for a closed polygon.
  std::vector<std::vector<VertexIndex>> polygons;
  std::vector<Vec3> holes;
};

/// A connected part of a TetGen facet: outer boundary, holes, and inner segments and points.
struct FacetPiece {
  std::vector<std::vector<VertexIndex>> loops;  ///< outer boundary first
  std::vector<std::array<VertexIndex, 2>> segments;
  std::vector<VertexIndex> points;
};

/// Divides a TetGen facet into connected pieces. A closed polygon with a hole point directly inside is a hole of the
/// polygon around it; anything inside that hole is a separate piece. A closed polygon without a hole point divides the
/// area around it by its segments. Containment is decided exactly in the plane of two axes.
std::vector<FacetPiece> facet_pieces(const std::vector<Vec3>& points, const TetgenFacet& facet);

}  // namespace geomesh::geomodel
