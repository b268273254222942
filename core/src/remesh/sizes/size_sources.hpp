// SPDX-License-Identifier: MIT
/// @file
/// Adds sources of target sizes over triangles, along curves and in gaps.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/geometry.hpp"
#include "geomesh/core/refine.hpp"
#include "remesh/domain/domain_mesh.hpp"

namespace geomesh::remesh {

/// Calls visit(centroid, radius) for pieces of the triangle, cut by a lattice twice as wide as the size and with at
/// most eight cells along each side.
template <class Visit>
void visit_pieces(const std::array<Vec3, 3>& corners, double size, const Visit& visit) {
  const auto& [a, b, c] = corners;
  const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
  const int n = std::clamp(static_cast<int>(std::ceil(longest / (2 * size))), 1, 8);
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      const double u = (i + 1.0 / 3) / n, v = (j + 1.0 / 3) / n;
      visit((1 - u - v) * a + u * b + v * c, 0.6 * longest / n);
    }
}

/// Adds sources at the points of a lattice over the triangle, twice the size apart, with at most 100 along each side.
void cover_triangle(const std::array<Vec3, 3>& corners, const AskedSize& asked, std::vector<SizeSource>& sources);
/// Adds sources along the curves of the mesh, with the sizes requested for the segments of the PLC on them, if any.
void cover_curves(const DomainMesh& mesh, const std::vector<AskedSize>& asked, std::vector<SizeSource>& sources);

/// Calls visit(face) for each side of a surface on which there is a cell.
template <class Visit>
void for_each_side_of_surfaces(const DomainMesh& mesh, const Visit& visit) {
  for (const CellIndex c : mesh.live_cells())
    for (unsigned i = 0; i < 4; ++i)
      if (mesh.tag(c, i).constrained()) visit(FaceRef(c, i));
}

/// Returns the distance from `origin`, a point of the constrained face, along its normal into the cell to the next
/// constrained face. The result is infinite if that face forms an angle of more than 60 degrees with the first one, if
/// both meet at a corner (they share a vertex, or their surfaces meet within `corner_reach`), or if no face is reached
/// within 500 cells.
double gap_width(const DomainMesh& mesh, FaceRef face, const Vec3& origin, double corner_reach = 0);

}  // namespace geomesh::remesh
