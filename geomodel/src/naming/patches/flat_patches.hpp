// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Represents patches of facets on sides of the box as polygons with holes.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "common/edge_uses.hpp"
#include "naming/patches/surface_sets.hpp"

namespace geomesh::geomodel {

/// A polygon that replaces all soup facets of a patch and has the same orientation.
struct FlatPatch {
  std::vector<Index> facets;                    ///< ascending
  std::vector<std::vector<VertexIndex>> loops;  ///< outer, holes
  /// Segments inside the patch, where other surfaces end on it.
  std::vector<std::pair<VertexIndex, VertexIndex>> segments;
  std::vector<VertexIndex> points;  ///< vertices inside the patch that are on no segment
};

/// Returns, by patch number, the patches that can be represented as polygons: their facets belong to one side of the
/// box only and have the same orientation, all their points have exactly the same x, y or z, and their border passes no
/// point twice. `uses` comes from sorted_edge_uses.
std::map<Index, FlatPatch> flat_box_patches(const PolygonSoup& soup, const std::vector<TriangulatedSurface>& surfaces,
                                            const SurfaceSets& sets, const std::vector<Index>& patch,
                                            const std::vector<EdgeUse>& uses);

}  // namespace geomesh::geomodel
