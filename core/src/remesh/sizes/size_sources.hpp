// SPDX-License-Identifier: MIT
/// @file
/// Sources of a size over triangles and line pieces, however long.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "geomesh/core/refine.hpp"
#include "quality/measure/shape.hpp"
#include "remesh/domain/domain_mesh.hpp"

namespace geomesh::remesh {

/// Calls visit(point, spacing) at the points of a lattice over the triangle, two sizes apart, at most 100 on a side.
template <class Visit>
void visit_lattice(const std::array<Vec3, 3>& corners, double size, const Visit& visit) {
  const auto& [a, b, c] = corners;
  const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
  const int n = std::clamp(static_cast<int>(std::ceil(longest / (2 * size))), 1, 100);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      const double u = static_cast<double>(i) / n, v = static_cast<double>(j) / n;
      visit((1 - u - v) * a + u * b + v * c, longest / n);
    }
}

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

inline void cover_triangle(const std::array<Vec3, 3>& corners, const AskedSize& asked,
                           std::vector<SizeSource>& sources) {
  visit_lattice(corners, asked.size, [&](const Vec3& p, double spacing) {
    sources.push_back({p, asked.size, asked.radius + 0.75 * spacing});
  });
}

inline void cover_piece(const Vec3& a, const Vec3& b, const AskedSize& asked, std::vector<SizeSource>& sources) {
  const double l = distance(a, b);
  const int n = std::clamp(static_cast<int>(std::ceil(l / (2 * asked.size))), 1, 10000);
  for (int i = 0; i <= n; ++i)
    sources.push_back({a + (static_cast<double>(i) / n) * (b - a), asked.size, asked.radius + 0.5 * l / n});
}

/// Calls visit(cell, face, corners, facet) for each face of a facet, once.
template <class Visit>
void for_each_face_of_facet(const DomainMesh& mesh, const Visit& visit) {
  for (CellIndex c = 0; c < mesh.n_slots(); ++c)
    for (unsigned i = 0; i < 4; ++i) {
      const FaceTag t = mesh.tag(c, i);
      if (!mesh.is_live(c) || !t.constrained() || t.facet() == hull_facet || (!t.above() && mesh.has_neighbor(c, i)))
        continue;
      const Tetrahedron& v = mesh.vertices(c);
      visit(c, i, Triangle{v[face_vertices[i][0]], v[face_vertices[i][1]], v[face_vertices[i][2]]}, t.facet());
    }
}

}  // namespace geomesh::remesh
