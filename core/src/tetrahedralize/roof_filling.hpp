// SPDX-License-Identifier: MIT
/// @file
/// Fills the space between a plane part and its roof (roofed_parts.hpp).
#pragma once

#include <vector>

#include "tetrahedralize/roofed_parts.hpp"

namespace geomesh {

/// Lifts the roof of `part` on each side where the mesh has cells, and fills the space under it. `part`, `roof` (the
/// faces of the part's roof) and `star` (the cells that have a point of the roof) refer to rows of `mesh`. Appends the
/// faces of the part's triangles to `faces`. Returns false if no height is possible; the mesh is then invalid.
bool fill_under_roof(ConstrainedTetrahedralization& mesh, const RoofedPart& part,
                     const std::vector<ConstrainedTetrahedralization::Face>& roof, const std::vector<Index>& star,
                     std::vector<ConstrainedTetrahedralization::Face>& faces);

}  // namespace geomesh
