// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Removes dangling faces: parts of a surface that are attached along one edge and are thinner than the merging
/// distance.
#pragma once

#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

struct CutDanglingFaces {
  std::size_t n_pieces = 0;
  Displacement moved;  ///< movement of the corners of removed facets to the surface that is kept
  std::vector<VanishedFacet> vanished;
};

/// A dangling piece is a part of one surface between its hinge and edges at which the surface ends. At the edges of the
/// hinge the surface has three facets or more. Where a needle beside it vanished, the surface is whole without it.
/// Dangling pieces that are wholly within the distance of their hinge are removed from the surface. Each edge of the
/// hinge keeps two facets of it or more. If one other surface ends on the piece, the piece becomes part of that
/// surface, which then continues to the hinge. If more surfaces meet it, the piece is kept. No facet moves, so nothing
/// new can cross. Unused points may be left. O(n log n).
CutDanglingFaces cut_dangling_faces(Complex& complex, double distance);

}  // namespace geomesh::geomodel::arrangement
