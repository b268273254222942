// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Parts of regions that a horizon parts from the rest of their region, and that were small enough to join it.
#pragma once

#include <vector>

#include "check/judged/claimed_faces.hpp"

namespace geomesh::geomodel::checking {

/// By face of claimed.candidates(): whether the face has one region on both sides and bounds a part of it that is
/// smaller than ClaimedNames::min_volume. Parts are joined across faces of no surface. All false where no small region
/// joins another one. Precondition: claimed.faces(). O(n log n) in the tetrahedra.
std::vector<bool> faces_of_small_parts(const ClaimedFaces& claimed);

}  // namespace geomesh::geomodel::checking
