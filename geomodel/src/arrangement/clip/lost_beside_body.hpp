// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What was outside of a body as given, and went with what is inside, since it was brought into the body before.
#pragma once

#include "arrangement/clip/body_shape.hpp"
#include "arrangement/clip/clip.hpp"

namespace geomesh::geomodel::arrangement {

/// Facets of one surface that a body cut off.
struct CutOff {
  Index surface = no_index;
  std::vector<Index> facets, left;  ///< rows of the arrangement: those that go, those that stay
};

/// How far points on edges of `cut` that were outside of the body are from what is left of their surface, at most.
/// Bringing together has moved the body and them by no more than `tolerance`; points within a thousandth of it count as
/// on the body. Where nothing is left it is the extent of what goes. Points are `tolerance` apart, or a 256th of their
/// edge. O(n log n), and O(n) for each point that is farther than all before it.
Displacement lost_beside_body(const Arranged& arranged, const CutOff& cut, const TriangulatedSurface& body,
                              const BodyShape& shape, double tolerance);

}  // namespace geomesh::geomodel::arrangement
