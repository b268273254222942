// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "corpus_builder.hpp"
#include "corpus_models.hpp"

namespace geomesh::test {

namespace {

/// n^3 cubes, every side a square facet: all vertices of a cube are cospherical, all sides of a plane coplanar.
PiecewiseLinearComplex cube_lattice(int n) {
  PlcBuilder b;
  const auto at = [](int x, int y, int z) { return Vec3{double(x), double(y), double(z)}; };
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        b.polygon({at(i, j, k), at(i, j + 1, k), at(i, j + 1, k + 1), at(i, j, k + 1)});
        b.polygon({at(j, i, k), at(j, i, k + 1), at(j + 1, i, k + 1), at(j + 1, i, k)});
        b.polygon({at(j, k, i), at(j + 1, k, i), at(j + 1, k + 1, i), at(j, k + 1, i)});
      }
  return b.plc;
}

/// Boxes on top of each other, their sides coplanar, heights from `thinnest` upward by doubling.
PiecewiseLinearComplex coplanar_stack(int n, double thinnest) {
  PlcBuilder b;
  double z = 0, height = thinnest;
  const auto level = [&](double h) { b.polygon({{0, 0, h}, {10, 0, h}, {10, 7, h}, {0, 7, h}}); };
  level(0);
  for (int i = 0; i < n; ++i) {
    const double above = z + height;
    const Vec3 corner[4] = {{0, 0, 0}, {10, 0, 0}, {10, 7, 0}, {0, 7, 0}};
    for (int k = 0; k < 4; ++k) {
      Vec3 a = corner[k], c = corner[(k + 1) % 4];
      a.z = c.z = z;
      Vec3 d = c, e = a;
      d.z = e.z = above;
      b.polygon({a, c, d, e});
    }
    level(above);
    z = above;
    height *= 2;
  }
  return b.plc;
}

/// Unit boxes on top of each other, their sides cut by diagonals in turns.
PiecewiseLinearComplex stack_of_triangles(int n) {
  PlcBuilder b;
  const Vec3 corner[4] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const auto at = [&](int k, int level) { return corner[k % 4] + Vec3{0, 0, double(level)}; };
  for (int i = 0; i <= n; ++i) b.polygon({at(0, i), at(1, i), at(2, i), at(3, i)});
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < 4; ++k) {
      const bool rising = (i + k) % 2 == 0;
      b.triangle(at(k, i), at(k + 1, i), at(rising ? k + 1 : k, i + 1));
      b.triangle(at(rising ? k : k + 1, i), at(k + 1, i + 1), at(k, i + 1));
    }
  return b.plc;
}

/// Sheets z = height(sheet, i, j) over a grid of n x n squares between flat top and bottom, sorted upwards; sheets may
/// coincide over parts (they pinch out there) and share the triangles. Sides are closed by triangles between
/// neighbouring sheets.
template <class Height>
PiecewiseLinearComplex layers(int n, int n_sheets, double spacing, Height height) {
  PlcBuilder b;
  const auto at = [&](int s, int i, int k) { return Vec3{spacing * i, spacing * k, height(s, i, k)}; };
  const auto sheet_triangle = [&](int s, const int(&c)[3][2]) {
    const auto coincides = [&](int below) {
      for (const auto& q : c)
        if (height(below, q[0], q[1]) != height(s, q[0], q[1])) return false;
      return true;
    };
    if (s > 0 && coincides(s - 1)) return;
    b.triangle(at(s, c[0][0], c[0][1]), at(s, c[1][0], c[1][1]), at(s, c[2][0], c[2][1]));
  };
  for (int s = 0; s < n_sheets; ++s)
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < n; ++k) {
        sheet_triangle(s, {{i, k}, {i + 1, k}, {i + 1, k + 1}});
        sheet_triangle(s, {{i, k}, {i + 1, k + 1}, {i, k + 1}});
      }
  const auto side = [&](int s, int i0, int k0, int i1, int k1) {
    const Vec3 a = at(s, i0, k0), c = at(s, i1, k1), d = at(s + 1, i1, k1), e = at(s + 1, i0, k0);
    if (!(c == d)) b.triangle(a, c, d);
    if (!(a == e)) b.triangle(a, d, e);
  };
  for (int s = 0; s + 1 < n_sheets; ++s)
    for (int i = 0; i < n; ++i) {
      side(s, i, 0, i + 1, 0);
      side(s, n, i, n, i + 1);
      side(s, i + 1, n, i, n);
      side(s, 0, i + 1, 0, i);
    }
  return b.plc;
}

/// Four layers, of which two end along curved lines inside the model.
PiecewiseLinearComplex pinching_layers(int n, double spacing, double vertical) {
  return layers(n, 5, spacing, [=](int s, int i, int k) {
    const double x = double(i) / n, y = double(k) / n;
    const double base = -10, top = 10 + std::sin(7 * x) + std::cos(5 * y);
    const double middle = 2 * std::sin(4 * x + 3 * y);
    // std::hypot would differ in its last bit on Windows, and the mesh is to be the same on every system.
    const double off_centre = std::sqrt((x - 0.3) * (x - 0.3) + (y - 0.4) * (y - 0.4));
    const double lower = std::max(0.0, 3 - 8 * off_centre), upper = std::max(0.0, 6 * (x - 0.45));
    const double z[5] = {base, middle - lower, middle, middle + upper, top};
    return vertical * z[s];
  });
}

/// Two horizons that come together along curved lines, so that the thin layer between them ends and begins again.
PiecewiseLinearComplex pinching_horizons(int n) {
  return layers(n, 4, 1.0 / n, [=](int s, int i, int k) {
    const double x = double(i) / n, y = double(k) / n, middle = 0.5 + 0.05 * std::sin(5 * x) * std::cos(4 * y);
    const double z[4] = {0, middle, middle + std::max(0.0, 0.03 * std::sin(6 * x + 2 * y)), 1};
    return z[s];
  });
}

}  // namespace

std::vector<CorpusModel> corpus_layers() {
  return {
      {"cube_lattice_2", 8, [] { return cube_lattice(2); }},
      {"cube_lattice_4", 64, [] { return cube_lattice(4); }},
      {"cube_lattice_5", 125, [] { return cube_lattice(5); }},
      {"cube_lattice_12", 1728, [] { return cube_lattice(12); }, true},
      {"coplanar_stack", 12, [] { return coplanar_stack(12, 1.0 / 128); }},
      {"coplanar_stack_thin", 8, [] { return coplanar_stack(8, 1e-6); }, false, false},
      {"stack_of_triangles", 8, [] { return stack_of_triangles(8); }},
      {"pinching_horizons", 4, [] { return pinching_horizons(16); }},
      {"pinching_layers", 4, [] { return pinching_layers(12, 1, 1); }},
      {"pinching_layers_fine", 4, [] { return pinching_layers(40, 1, 1); }, true},
      {"flat_layers", 4, [] { return pinching_layers(12, 1, 1e-4); }, false, false},
      {"flat_layers_wide", 4, [] { return pinching_layers(16, 1000, 0.1); }},
  };
}

std::vector<CorpusModel> corpus_models() {
  std::vector<CorpusModel> all = corpus_polyhedra();
  for (auto part : {corpus_contacts(), corpus_layers()}) all.insert(all.end(), part.begin(), part.end());
  return all;
}

CorpusModel corpus_model(const std::string& name) {
  for (CorpusModel& m : corpus_models())
    if (m.name == name) return m;
  throw std::out_of_range("no corpus model " + name);
}

}  // namespace geomesh::test
