// SPDX-License-Identifier: MIT
// The Delaunay tetrahedralization of a point set: walks over the finite cells, counts edges and prints Euler's sum.
#include <algorithm>
#include <array>
#include <cstdio>
#include <geomesh/core/delaunay.hpp>
#include <set>
#include <vector>

using namespace geomesh;

int main() {
  std::vector<Vec3> points;
  unsigned random = 1;
  const auto next = [&] { return (random = random * 1664525u + 1013904223u) / 4294967296.0; };
  for (int i = 0; i < 1000; ++i) points.push_back({next(), next(), next()});

  const DelaunayTetrahedralization delaunay = delaunay_tetrahedralization(points);
  const TetMesh& mesh = delaunay.mesh;
  std::set<std::array<VertexIndex, 2>> edges;
  std::set<std::array<VertexIndex, 3>> faces;
  long cells = 0;
  for (CellIndex c = 0; c < mesh.n_slots(); ++c) {
    if (!mesh.is_live(c) || mesh.is_ghost(c)) continue;  // ghosts join the hull to the vertex at infinity
    ++cells;
    std::array<VertexIndex, 4> v;
    for (unsigned i = 0; i < 4; ++i) v[i] = mesh.vertex(c, i);
    std::sort(v.begin(), v.end());
    for (unsigned i = 0; i < 4; ++i)
      for (unsigned j = i + 1; j < 4; ++j) {
        edges.insert({v[i], v[j]});
        for (unsigned k = j + 1; k < 4; ++k) faces.insert({v[i], v[j], v[k]});
      }
  }
  const long euler = long(points.size()) - long(edges.size()) + long(faces.size()) - cells;
  std::printf("%ld tetrahedra, %zu faces, %zu edges; Euler's sum %ld\n", cells, faces.size(), edges.size(), euler);
  return euler == 1 ? 0 : 1;  // a ball
}
