// SPDX-License-Identifier: MIT
/// @file
/// Fills the space between a plane polygon and its roof, a triangulated surface lifted off it (roofed_parts.hpp).
#pragma once

#include <vector>

#include "tetrahedralize/roofed_parts.hpp"

namespace geomesh {

/// Lifts the roof, a triangulation of a plane polygon with inner points, off the plane on each side that has cells, and
/// fills the space between them. `roof` has the roof's faces, `star` the cells at its inner points. Appends the faces
/// of the polygon's own triangles to `faces`. Returns false if no height is possible; the mesh is then invalid.
bool fill_under_roof(ConstrainedTetrahedralization& mesh, const RoofedPart& part,
                     const std::vector<ConstrainedTetrahedralization::Face>& roof, const std::vector<Index>& star,
                     std::vector<ConstrainedTetrahedralization::Face>& faces);

}  // namespace geomesh
