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
  /// Areas of the triangle that no mesh face covers: beyond a surface that cuts this one by rule, and elsewhere.
  double beyond = 0, within = 0;
  std::array<bool, 3> goes_on{};  ///< for side i (corner i to i + 1), whether mesh faces leave a point of it uncovered
  /// Whether open edges of the mesh faces on this triangle run only along cutting surfaces or the surface's own border.
  bool ends_at_cutters = true;
  Vec3 place{};  ///< of the rest
};

/// Returns the indices in `uncovered`, a list of input triangles that mesh faces do not cover, of those that must be
/// covered. Triangles are in one piece if they share a side that is uncovered. A piece may be missing in the mesh if
/// most of its area is beyond a surface that cuts it by rule, and if the mesh faces around it end only at such
/// surfaces. O(n log n).
std::vector<Index> not_taken_as_pieces(const TriangulatedSurface& surface,
                                       const std::vector<UncoveredTriangle>& uncovered);

}  // namespace geomesh::geomodel::checking
