// SPDX-License-Identifier: MIT
// A box parted by a horizon that is not flat, meshed to a size with the core alone: prints the two volumes and the
// least angle.
#include <cstdio>
#include <geomesh/core/quality.hpp>
#include <geomesh/core/refine.hpp>
#include <geomesh/core/tetrahedralize.hpp>

using namespace geomesh;

int main() {
  // Corners of the box from below: 0-3 the bottom, 4-7 the border of the horizon, 8-11 the top. 12 is the horizon's
  // crest.
  PiecewiseLinearComplex plc;
  for (const double z : {0.0, 1.0, 2.0})
    for (const auto& [x, y] : {Vec2{0, 0}, Vec2{2, 0}, Vec2{2, 2}, Vec2{0, 2}}) plc.points.push_back({x, y, z});
  plc.points.push_back({1, 1, 1.3});
  const auto polygon = [&](std::vector<VertexIndex> loop) { plc.add_polygon({&loop, 1}); };
  polygon({0, 3, 2, 1});
  polygon({8, 9, 10, 11});
  for (VertexIndex i = 0; i < 4; ++i) {
    const VertexIndex j = (i + 1) % 4;
    polygon({i, j, j + 4, i + 4});
    polygon({i + 4, j + 4, j + 8, i + 8});
    plc.add_triangle({i + 4, j + 4, 12});
  }
  try {
    RefineOptions refine;
    refine.size.global = 0.4;
    const RefineResult result = refine_and_improve(plc, tetrahedralize(plc), refine);
    std::vector<double> volume(result.mesh.n_components, 0);
    double least = 180;
    for (std::size_t t = 0; t < result.mesh.tetrahedra.size(); ++t) {
      const Tetrahedron& v = result.mesh.tetrahedra[t];
      const auto& p = result.mesh.points;
      const TetrahedronShape shape = tetrahedron_shape(p[v[0]], p[v[1]], p[v[2]], p[v[3]]);
      volume[result.mesh.component[t]] += shape.volume;
      least = shape.min_dihedral < least ? shape.min_dihedral : least;
    }
    std::printf("%zu tetrahedra; volumes %.6f and %.6f; least angle %.1f degrees\n", result.mesh.tetrahedra.size(),
                volume.at(0), volume.at(1), least);
    const double sum = volume[0] + volume[1];
    return result.mesh.n_components == 2 && sum > 8 - 1e-9 && sum < 8 + 1e-9 && least > 5 ? 0 : 1;
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());  // what is wrong, where, what to do; context() has the places
    return static_cast<int>(error.kind());
  }
}
