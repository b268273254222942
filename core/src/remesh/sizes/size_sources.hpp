// SPDX-License-Identifier: MIT
/// @file
/// Sources of a size over triangles, curves and gaps, however long or wide.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/geometry.hpp"
#include "geomesh/core/refine.hpp"
#include "remesh/domain/domain_mesh.hpp"

namespace geomesh::remesh {

/// Calls visit(centroid, radius) for the pieces into which a lattice cuts the triangle: two sizes wide, at most eight
/// on a side.
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

/// At the points of a lattice over the triangle, two sizes apart, at most 100 on a side.
void cover_triangle(const std::array<Vec3, 3>& corners, const AskedSize& asked, std::vector<SizeSource>& sources);
/// Along the mesh's curves, by row of their segments, which may be fewer.
void cover_curves(const DomainMesh& mesh, const std::vector<AskedSize>& asked, std::vector<SizeSource>& sources);

/// visit(face) for each side of a surface that has a cell.
template <class Visit>
void for_each_side_of_surfaces(const DomainMesh& mesh, const Visit& visit) {
  for (const CellIndex c : mesh.live_cells())
    for (unsigned i = 0; i < 4; ++i)
      if (mesh.tag(c, i).constrained()) visit(FaceRef(c, i));
}

/// Distance from `origin`, a point of the constrained face, along its normal into the cell to the next constrained face
/// that faces back. Infinite where that face stands at more than 60 degrees to this one. Infinite at a corner, which is
/// no gap: where both share a vertex, or the surfaces meet within `corner_reach`. Infinite too where 500 cells do not
/// reach one.
double gap_width(const DomainMesh& mesh, FaceRef face, const Vec3& origin, double corner_reach = 0);

}  // namespace geomesh::remesh
