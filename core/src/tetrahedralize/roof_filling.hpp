// SPDX-License-Identifier: MIT
/// @file
/// The space between a plane part and its roof (roofed_parts.hpp).
#pragma once

#include <vector>

#include "tetrahedralize/roofed_parts.hpp"

namespace geomesh {

/// Lifts the roof of `part` on each side where the mesh has cells, and fills the space under it. All are in rows of
/// `mesh`: `roof`, its faces that are the part's roof, and `star`, its cells that have a point of the roof. Appends the
/// faces of the part's triangles to `faces`. False where no step is small enough; the mesh is of no use then.
bool fill_under_roof(ConstrainedTetrahedralization& mesh, const RoofedPart& part,
                     const std::vector<ConstrainedTetrahedralization::Face>& roof, const std::vector<Index>& star,
                     std::vector<ConstrainedTetrahedralization::Face>& faces);

}  // namespace geomesh
