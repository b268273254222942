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

/// Removes dangling pieces of surfaces. A dangling piece is a part of one surface between its hinge and edges at which
/// the surface ends. At the edges of the hinge the surface has three facets or more. They arise where a needle
/// vanished, and the surface is whole without them. A piece is removed from its surface if all of it is within the
/// distance of its hinge. Each edge of the hinge keeps at least two facets of the surface. If one other surface ends on
/// the piece, the piece becomes part of that surface, which then continues to the hinge. If more surfaces meet the
/// piece, it is kept. No facet moves, so no new crossings can arise. Unused points may be left. O(n log n).
CutDanglingFaces cut_dangling_faces(Complex& complex, double distance);

}  // namespace geomesh::geomodel::arrangement
