// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Rounds exact vertices to doubles.
#pragma once

#include "arrangement/model/arranged.hpp"

namespace geomesh::geomodel::arrangement {

struct RoundingOptions {
  /// 0: constructed points go to their nearest doubles. Else to a vertex of the changed facets or an earlier
  /// constructed point where one is nearer than this: crossings then bend to vertices that are there instead of making
  /// ever more of them (as hot pixels do in snap rounding: Hobby 1999).
  double snap = 0;
  std::optional<Box3> box;        ///< points on its planes stay on them
  bool onto_sides_alone = false;  ///< only points off a plane of the box, but nearer to it than `snap`, go elsewhere
};

struct Rounded {
  Complex complex;
  Displacement displacement;
  std::vector<VanishedFacet> vanished;
};

/// Merges vertices with equal doubles. Facets that lose their area by that are dropped: their neighbours take their
/// place, or the next round mends them. Only used vertices are kept, those of the complex first. Marks facets and
/// segments that may have become improper as dirty.
Rounded round_to_doubles(const Arranged& arranged, const Complex& before, const RoundingOptions& options);

}  // namespace geomesh::geomodel::arrangement
