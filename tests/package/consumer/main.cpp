// SPDX-License-Identifier: MIT
// A program of somebody else's that meshes a unit cube with the installed core.
#include <cmath>
#include <cstdio>
#include <geomesh/core/tetrahedralize.hpp>

int main() {
  geomesh::PiecewiseLinearComplex plc;
  for (int i = 0; i < 8; ++i) plc.points.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  const std::vector<geomesh::VertexIndex> sides[6] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                                      {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& side : sides) plc.add_polygon({&side, 1});

  const geomesh::ConstrainedTetrahedralization mesh = geomesh::tetrahedralize(plc);
  double volume = 0;
  for (const auto& t : mesh.tetrahedra) {
    const auto& p = mesh.points;
    volume += dot(p[t[3]] - p[t[0]], cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]])) / 6;
  }
  std::printf("%zu tetrahedra, volume %.17g\n", mesh.tetrahedra.size(), volume);
  return mesh.n_components == 1 && std::abs(volume - 1) < 1e-15 ? 0 : 1;
}
