// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Decides which uncovered pieces of a horizon may be missing as a whole, although parts of them are not beyond the
/// horizon that cuts: a piece may continue where the cutting horizon has ended.
#pragma once

#include <array>
#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel::checking {

/// A triangle of an input surface that mesh faces cover incompletely or not at all.
struct UncoveredTriangle {
  Index triangle;
  /// Area that mesh faces do not cover: the part beyond a surface that cuts this one, and the part that no rule
  /// removes.
  double beyond = 0, within = 0;
  std::array<bool, 3> goes_on{};  ///< whether a point of side i (corner i to i + 1) is on no mesh face
  /// Whether open edges of the mesh faces on this triangle run only along cutting surfaces or the surface's own border.
  bool ends_at_cutters = true;
  Vec3 place{};  ///< of the rest
};

/// Selects from `uncovered` (triangles that mesh faces do not cover) those that must be covered; returns their rows.
/// Triangles form one piece if they are joined across uncovered sides. A piece may be missing in the mesh if most of
/// its area is beyond the surface that cuts it and its mesh faces end only at cutting surfaces. O(n log n).
std::vector<Index> not_taken_as_pieces(const TriangulatedSurface& surface,
                                       const std::vector<UncoveredTriangle>& uncovered);

}  // namespace geomesh::geomodel::checking
