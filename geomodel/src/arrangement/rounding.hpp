// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// From exact vertices to doubles.
#pragma once

#include "arranged.hpp"

namespace geomesh::geomodel::arrangement {

struct RoundingOptions {
  double grid = 0;          ///< 0: nearest doubles; else a power of two to whose multiples constructed points go
  std::optional<Box3> box;  ///< points on its planes stay on them, points inside stay inside
};

struct Rounded {
  Complex complex;
  Displacement displacement;
  std::size_t n_facets_collapsed = 0;
};

/// Vertices that get equal doubles become one; facets that lose their area by that are dropped (their neighbours take their place,
/// or the next round mends them). Only used vertices are kept, those of the complex first. Marks what may have become improper as dirty.
Rounded round_to_doubles(const Arranged& arranged, const Complex& before, const RoundingOptions& options);

}  // namespace geomesh::geomodel::arrangement
