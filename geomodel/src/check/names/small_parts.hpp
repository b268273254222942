// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Parts of regions that a horizon parts from the rest of their region, and that were small enough to join it.
#pragma once

#include <vector>

#include "check/judged/claimed_faces.hpp"

namespace geomesh::geomodel::checking {

/// Whether the cell on that side of a face is in a small part of its region.
struct SmallSides {
  bool minus = false, plus = false;
};

/// By face of claimed.candidates(). A part is small that is smaller than ClaimedNames::min_volume and not the largest
/// of its region. Parts are joined across faces of no surface. None where no small region joins another one.
/// Precondition: claimed.faces(). O(n log n) in the tetrahedra.
std::vector<SmallSides> sides_in_small_parts(const ClaimedFaces& claimed);

}  // namespace geomesh::geomodel::checking
