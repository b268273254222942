// SPDX-License-Identifier: MIT
/// @file
/// Merges the triangles of a plane patch into few convex polygons (S. Hertel and K. Mehlhorn, "Fast triangulation of
/// simple polygons", 1983). Inner edges are removed while the polygons remain convex, which leaves at most four times
/// the least possible number of polygons.
#pragma once

#include <span>
#include <vector>

#include "plc/flat_patch.hpp"
#include "plc/patch_crossings.hpp"

namespace geomesh {

struct ConvexPart {
  /// Border vertices of the part in the orientation of the patch's triangles; angles of 180 degrees are allowed.
  std::vector<VertexIndex> border;
  std::vector<Index> triangles;       ///< the patch's triangles that make up the part, ascending
  std::vector<InnerEdge> left_out{};  ///< edges inside the part, between two of its triangles
};

/// Returns the convex parts of the patch, ordered by their smallest triangle. `segments` are edges that must be kept,
/// in any order. O(n log n).
std::vector<ConvexPart> convex_parts(const FlatPatch& patch, std::span<const FlatPatch::Edge> segments);

}  // namespace geomesh
