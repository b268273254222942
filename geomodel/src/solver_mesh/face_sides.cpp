// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver_mesh/face_sides.hpp"

#include <algorithm>

#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh::geomodel {

namespace {

struct Sorted {
  Triangle vertices;
  bool even;
};

Sorted sorted(Triangle t) {
  bool even = true;
  for (std::size_t pass = 0; pass < 2; ++pass)
    for (std::size_t i = 0; i < 2; ++i)
      if (t[i] > t[i + 1]) {
        std::swap(t[i], t[i + 1]);
        even = !even;
      }
  return {t, even};
}

}  // namespace

std::vector<std::array<TetrahedronSide, 2>> tetrahedra_at_faces(const std::vector<Tetrahedron>& tetrahedra,
                                                                const std::vector<Triangle>& faces) {
  struct Face {
    Triangle vertices;
    bool even;
    std::size_t row;
  };
  std::vector<Face> list;
  list.reserve(faces.size());
  std::size_t n_vertices = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Sorted s = sorted(faces[f]);
    list.push_back({s.vertices, s.even, f});
    n_vertices = std::max<std::size_t>(n_vertices, s.vertices[2] + 1u);
  }
  std::sort(list.begin(), list.end(), [](const Face& a, const Face& b) {
    return a.vertices != b.vertices ? a.vertices < b.vertices : a.row < b.row;
  });
  std::vector<std::size_t> first(n_vertices + 1, 0);  // faces by their smallest vertex
  for (const Face& face : list) ++first[face.vertices[0] + 1];
  for (std::size_t v = 0; v < n_vertices; ++v) first[v + 1] += first[v];
  std::vector<std::array<TetrahedronSide, 2>> sides(faces.size(), {{{no_side, 0}, {no_side, 0}}});
  for (std::size_t t = 0; t < tetrahedra.size(); ++t)
    for (std::size_t i = 0; i < 4; ++i) {
      const Tetrahedron& v = tetrahedra[t];
      const Sorted s = sorted({v[face_vertices[i][0]], v[face_vertices[i][1]], v[face_vertices[i][2]]});
      if (s.vertices[0] >= n_vertices) continue;
      const auto end = list.begin() + static_cast<std::ptrdiff_t>(first[s.vertices[0] + 1]);
      auto face = std::lower_bound(list.begin() + static_cast<std::ptrdiff_t>(first[s.vertices[0]]), end, s.vertices,
                                   [](const Face& a, const Triangle& b) { return a.vertices < b; });
      // A tetrahedron's own face normal points inwards: one that agrees with it looks to this tetrahedron.
      for (; face != end && face->vertices == s.vertices; ++face)
        sides[face->row][face->even == s.even ? 1 : 0] = {t, static_cast<unsigned>(i)};
    }
  return sides;
}

std::vector<std::array<std::size_t, 4>> tetrahedra_across(const std::vector<Tetrahedron>& tetrahedra) {
  struct Use {
    Triangle vertices;
    std::size_t tetrahedron, face;
  };
  std::vector<Use> uses;
  uses.reserve(4 * tetrahedra.size());
  for (std::size_t t = 0; t < tetrahedra.size(); ++t)
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& v = tetrahedra[t];
      uses.push_back({sorted({v[face_vertices[i][0]], v[face_vertices[i][1]], v[face_vertices[i][2]]}).vertices, t, i});
    }
  std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
    return a.vertices != b.vertices ? a.vertices < b.vertices : a.tetrahedron < b.tetrahedron;
  });
  std::vector<std::array<std::size_t, 4>> across(tetrahedra.size(), {no_side, no_side, no_side, no_side});
  for (std::size_t k = 0; k + 1 < uses.size(); ++k) {
    if (uses[k].vertices != uses[k + 1].vertices) continue;
    across[uses[k].tetrahedron][uses[k].face] = uses[k + 1].tetrahedron;
    across[uses[k + 1].tetrahedron][uses[k + 1].face] = uses[k].tetrahedron;
  }
  return across;
}

}  // namespace geomesh::geomodel
