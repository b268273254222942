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

/// Removes dangling pieces of surfaces. A dangling piece is a part of one surface that is attached along its hinge,
/// edges at which the surface has three facets or more; at all its other edges the surface ends. Such pieces arise
/// where a needle vanished; the surface has no hole without them. A piece is removed from its surface if all of it is
/// within `distance` of its hinge, at which the surface keeps at least two facets at each edge. If one other surface
/// ends on the piece, the piece becomes part of that surface, which then continues to the hinge. If more surfaces meet
/// the piece, it is kept. No facet moves, so no new crossings can arise. Unused points may be left. O(n log n).
CutDanglingFaces cut_dangling_faces(Complex& complex, double distance);

}  // namespace geomesh::geomodel::arrangement
