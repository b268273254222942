// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Pieces of a horizon that the rules take as wholes, though parts of them are not beyond the horizon that cuts: a
/// piece may go on where the other one has ended.
#pragma once

#include <array>
#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel::checking {

/// A triangle of one surface of the input that mesh faces do not cover, or not all of it.
struct UncoveredTriangle {
  Index triangle;
  double beyond = 0, within = 0;  ///< its area without faces that a rule may take place by place, and the rest
  std::array<bool, 3> goes_on{};  ///< whether a place of side i (corner i to i + 1) is without faces
  bool ends_at_cutters = true;    ///< open edges of its faces run along what cuts the surface, or its border
  Vec3 place{};                   ///< of the rest
};

/// The rows of `uncovered` in pieces that may not be away. Triangles are joined across sides without faces. A piece may
/// be away where most of its area is beyond what cuts it and where it ends at cutters alone. O(n log n).
std::vector<Index> not_taken_as_pieces(const TriangulatedSurface& surface,
                                       const std::vector<UncoveredTriangle>& uncovered);

}  // namespace geomesh::geomodel::checking
