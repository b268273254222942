// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds parts of regions that a horizon cuts off, and that were small enough to be merged into their region.
#pragma once

#include <vector>

#include "check/mesh/checked_faces.hpp"

namespace geomesh::geomodel::checking {

struct SmallSides {
  bool minus = false, plus = false;
};

/// Returns for each face of `checked.candidates()` on which of its sides the cell is in a small part of its region. A
/// part is small if it is smaller than SpecifiedNames::min_volume and not the largest of its region. Cells form one
/// part if they are joined across faces that are on no surface. Empty if small regions are not merged into others.
/// Precondition: `checked.faces()`. O(n log n) in the tetrahedra.
std::vector<SmallSides> sides_in_small_parts(const CheckedFaces& checked);

}  // namespace geomesh::geomodel::checking
