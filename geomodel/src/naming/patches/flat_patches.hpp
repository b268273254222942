// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Patches on box sides as polygons with holes.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "common/edge_uses.hpp"
#include "naming/patches/surface_sets.hpp"

namespace geomesh::geomodel {

/// One patch of soup facets as one polygon in their orientation.
struct FlatPatch {
  std::vector<Index> facets;                                  ///< ascending
  std::vector<std::vector<VertexIndex>> loops;                ///< outer, holes
  std::vector<std::pair<VertexIndex, VertexIndex>> segments;  ///< inside, where something else ends on the patch
  std::vector<VertexIndex> points;                            ///< inside, on no segment
};

/// Patches (by number) of facets of one box side alone that are oriented alike. All their points have exactly the same
/// x, y or z, and their border passes no point twice. `uses` as from sorted_edge_uses.
std::map<Index, FlatPatch> flat_box_patches(const PolygonSoup& soup, const std::vector<TriangulatedSurface>& surfaces,
                                            const SurfaceSets& sets, const std::vector<Index>& patch,
                                            const std::vector<EdgeUse>& uses);

}  // namespace geomesh::geomodel
