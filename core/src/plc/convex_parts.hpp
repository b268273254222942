// SPDX-License-Identifier: MIT
/// @file
/// A triangulated plane patch as few convex polygons (S. Hertel and K. Mehlhorn, "Fast triangulation of simple
/// polygons", 1983: inner edges are left out while the polygons stay convex, which leaves at most four times as many
/// polygons as there must be).
#pragma once

#include <span>
#include <vector>

#include "plc/flat_patch.hpp"
#include "plc/patch_crossings.hpp"

namespace geomesh {

struct ConvexPart {
  /// Same orientation as the triangles of the patch; angles of 180 degrees are allowed.
  std::vector<VertexIndex> border;
  std::vector<Index> triangles;       ///< triangles of the patch, ascending
  std::vector<InnerEdge> left_out{};  ///< edges between them
};

/// Returns the parts of the patch, ordered by their smallest triangle. `segments` are edges that are not left out, in
/// any order. O(n log n).
std::vector<ConvexPart> convex_parts(const FlatPatch& patch, std::span<const FlatPatch::Edge> segments);

}  // namespace geomesh
