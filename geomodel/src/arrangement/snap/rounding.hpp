// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Rounds exact vertices to doubles.
#pragma once

#include "arrangement/model/arranged.hpp"

namespace geomesh::geomodel::arrangement {

struct RoundingOptions {
  /// Snapping distance. With 0, constructed points are rounded to their nearest doubles. Otherwise a point closer than
  /// this to a vertex of the changed facets, or to an earlier constructed point, is moved there. Crossings then bend to
  /// existing vertices instead of making ever more of them (like hot pixels in snap rounding: Hobby 1999).
  double snap = 0;
  std::optional<Box3> box;  ///< points on the planes of the model's box remain on them
  /// Restricts snapping to points that are closer to a plane of the box than `snap`, but not on it.
  bool onto_sides_alone = false;
};

struct Rounded {
  Complex complex;
  Displacement displacement;
  std::vector<VanishedFacet> vanished;
};

/// Rounds the vertices of an arrangement. Merges vertices with equal doubles. Drops facets that lose their area: their
/// neighbours replace them, or the next round mends the gap. Keeps only used vertices, those of the complex first.
/// Marks facets and segments that may have become invalid as dirty.
Rounded round_to_doubles(const Arranged& arranged, const Complex& before, const RoundingOptions& options);

}  // namespace geomesh::geomodel::arrangement
