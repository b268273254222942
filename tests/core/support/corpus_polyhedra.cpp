// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <numbers>

#include "corpus_builder.hpp"
#include "corpus_models.hpp"
#include "plc_reader.hpp"
#include "test_places.hpp"

namespace geomesh::test {

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Schönhardt (1928): a prism over a triangle, twisted, its sides folded inwards; no tetrahedron of its six vertices
/// lies inside.
Shell schonhardt(double twist_degrees) {
  Shell shell;
  for (int layer = 0; layer < 2; ++layer)
    for (int i = 0; i < 3; ++i) {
      const double angle = (120 * i + layer * twist_degrees) * degree;
      shell.points.push_back({std::cos(angle), std::sin(angle), static_cast<double>(layer)});
    }
  shell.triangles = {{0, 2, 1}, {3, 4, 5}};
  for (VertexIndex i = 0; i < 3; ++i) {
    const VertexIndex k = (i + 1) % 3;
    shell.triangles.push_back({i, k, i + 3});
    shell.triangles.push_back({k, k + 3, i + 3});
  }
  Shell other = shell;
  for (VertexIndex i = 0; i < 3; ++i) {
    const VertexIndex k = (i + 1) % 3;
    other.triangles[2 + 2 * i] = {i, k, k + 3};
    other.triangles[3 + 2 * i] = {i, k + 3, i + 3};
  }
  return volume(shell) < volume(other) ? shell : other;
}

PiecewiseLinearComplex schonhardt_model(double twist, bool in_box) {
  PlcBuilder b;
  if (in_box) b.box({-2, -2, -1}, {2, 2, 2});
  add_shell(b, schonhardt(twist));
  return b.plc;
}

/// Chazelle (1984), "Convex partitions of polyhedra": notches from below end on the lines x = i of z = xy, notches from
/// above on the lines y = i of z = xy + gap. Any tetrahedralization needs a number of points and cells quadratic in the
/// number of notches.
PiecewiseLinearComplex chazelle(int n, double gap) {
  PlcBuilder b;
  const double m = n + 1, top = m * m + 1, bottom = -1, w = 1.0 / 32;
  std::vector<Vec3> front{{0, 0, bottom}}, back{{0, m, bottom}}, left, right;
  double last = 0;
  for (int i = 1; i <= n; ++i) {
    const double x = i;
    const Vec3 a0{x, 0, 0}, a1{x, m, x * m}, l0{x - w, 0, bottom}, l1{x - w, m, bottom}, r0{x + w, 0, bottom},
        r1{x + w, m, bottom};
    for (const Vec3& p : {l0, a0, r0}) front.push_back(p);
    for (const Vec3& p : {l1, a1, r1}) back.push_back(p);
    b.polygon({{last, 0, bottom}, {last, m, bottom}, l1, l0});
    b.triangle(l0, l1, a0);
    b.triangle(l1, a1, a0);
    b.triangle(a0, a1, r1);
    b.triangle(a0, r1, r0);
    last = x + w;
  }
  b.polygon({{last, 0, bottom}, {last, m, bottom}, {m, m, bottom}, {m, 0, bottom}});
  for (const Vec3& p : {Vec3{m, 0, bottom}, Vec3{m, 0, top}, Vec3{0, 0, top}}) front.push_back(p);
  for (const Vec3& p : {Vec3{m, m, bottom}, Vec3{m, m, top}, Vec3{0, m, top}}) back.push_back(p);
  left = {{0, 0, top}};
  right = {{m, 0, top}};
  last = 0;
  for (int i = 1; i <= n; ++i) {
    const double y = i;
    const Vec3 a0{0, y, gap}, a1{m, y, m * y + gap}, l0{0, y - w, top}, l1{m, y - w, top}, r0{0, y + w, top},
        r1{m, y + w, top};
    for (const Vec3& p : {l0, a0, r0}) left.push_back(p);
    for (const Vec3& p : {l1, a1, r1}) right.push_back(p);
    b.polygon({{0, last, top}, {m, last, top}, l1, l0});
    b.triangle(l0, l1, a1);
    b.triangle(l0, a1, a0);
    b.triangle(a0, a1, r1);
    b.triangle(a0, r1, r0);
    last = y + w;
  }
  b.polygon({{0, last, top}, {m, last, top}, {m, m, top}, {0, m, top}});
  for (const Vec3& p : {Vec3{0, m, top}, Vec3{0, m, bottom}, Vec3{0, 0, bottom}}) left.push_back(p);
  for (const Vec3& p : {Vec3{m, m, top}, Vec3{m, m, bottom}, Vec3{m, 0, bottom}}) right.push_back(p);
  b.polygon(front);
  b.polygon(std::vector<Vec3>(back.rbegin(), back.rend()));
  b.polygon(left);
  b.polygon(std::vector<Vec3>(right.rbegin(), right.rend()));
  return b.plc;
}

/// The same obstacle from plates: rectangles that hang in a box, n across the lines x = i of z = xy from below and n
/// across y = i from above.
PiecewiseLinearComplex hanging_plates(int n) {
  PlcBuilder b;
  const double m = n + 1, top = m * m + 1, gap = 0.01;
  b.box({0, 0, -1}, {m, m, top});
  for (int i = 1; i <= n; ++i) {
    const double x = i;
    b.polygon({{x, 0.5, -0.5}, {x, m - 0.5, -0.5}, {x, m - 0.5, x * (m - 0.5)}, {x, 0.5, x * 0.5}});
  }
  for (int i = 1; i <= n; ++i) {
    const double y = i;
    b.polygon(
        {{0.5, y, top - 0.5}, {m - 0.5, y, top - 0.5}, {m - 0.5, y, y * (m - 0.5) + gap}, {0.5, y, y * 0.5 + gap}});
  }
  return b.plc;
}

/// Figure 2 of the paper: a vertex with many incident segments at small angles over a base that is not planar, the base
/// of a solid.
PiecewiseLinearComplex high_degree_vertex(int n) {
  PlcBuilder b;
  const Vec3 centre{0, 0, 3}, top{0.1, 0.2, 40};
  std::vector<Vec3> rim, upper;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n, r = 10 + (i % 3);
    rim.push_back({r * std::cos(angle), r * std::sin(angle), 1.5 * std::sin(5 * angle) + 0.25 * (i % 2)});
    upper.push_back({12 * std::cos(angle), 12 * std::sin(angle), 20.0 + i % 2});
  }
  for (int i = 0; i < n; ++i) {
    const int k = (i + 1) % n;
    b.triangle(centre, rim[k], rim[i]);
    b.triangle(rim[i], rim[k], upper[k]);
    b.triangle(rim[i], upper[k], upper[i]);
    b.triangle(upper[i], upper[k], top);
  }
  return b.plc;
}

/// The same with a base whose rim is higher and lower in turn and one apex above it: nearly all segments meet in two
/// vertices.
PiecewiseLinearComplex fan_of_segments(int n) {
  PlcBuilder b;
  const Vec3 centre{0, 0, 0.3}, top{0.1, -0.2, 3};
  std::vector<Vec3> rim;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n, r = i % 3 == 0 ? 1.0 : i % 3 == 1 ? 2.3 : 0.4;
    rim.push_back({r * std::cos(angle), r * std::sin(angle), 0.11 * ((i * 7) % 5)});
  }
  for (int i = 0; i < n; ++i) {
    const int k = (i + 1) % n;
    b.triangle(centre, rim[k], rim[i]);
    b.triangle(top, rim[i], rim[k]);
  }
  return b.plc;
}

/// A bundle of needles from one vertex, all within a few degrees.
PiecewiseLinearComplex needle_bundle(int n) {
  PlcBuilder b;
  b.box({-2, -2, -1}, {2, 2, 12});
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n, r = 0.5 + 0.01 * (i % 7);
    b.segment({0, 0, 0}, {r * std::cos(angle), r * std::sin(angle), 10 + 0.125 * (i % 5)}, static_cast<Index>(i));
  }
  return b.plc;
}

/// Figure 4 of the paper: four pyramids whose apices touch, and a block across them. The block is the cube |x|,|y|,|z|
/// <= 1 about the common apex; where a pyramid with a square base of half side s at distance h leaves the cube it has
/// cut a square of half side s/h into the cube's side. All that lies in a side of the block is one facet with a hole.
PiecewiseLinearComplex pyramids_and_block(double half_side) {
  PlcBuilder b;
  const double far = 4, s = half_side;
  const auto turned = [](const Vec3& p, int quarter) {
    return quarter == 0   ? p
           : quarter == 1 ? Vec3{-p.y, p.x, p.z}
           : quarter == 2 ? Vec3{-p.x, -p.y, p.z}
                          : Vec3{p.y, -p.x, p.z};
  };
  for (int q = 0; q < 4; ++q) {
    const auto at = [&](double distance, int corner) {
      const double y = corner == 0 || corner == 3 ? -s : s, z = corner < 2 ? -s : s;
      return turned({distance, y * distance, z * distance}, q);
    };
    const auto block = [&](double y, double z) { return turned({1, y, z}, q); };
    const std::vector<std::vector<Vec3>> side{{block(-1, -1), block(1, -1), block(1, 1), block(-1, 1)},
                                              {at(1, 0), at(1, 1), at(1, 2), at(1, 3)}};
    b.polygon_with_holes(side);
    b.polygon({at(1, 0), at(1, 1), at(1, 2), at(1, 3)});
    b.polygon({at(far, 0), at(far, 1), at(far, 2), at(far, 3)});
    for (int c = 0; c < 4; ++c) {
      const int d = (c + 1) % 4;
      b.triangle({0, 0, 0}, at(1, d), at(1, c));
      b.polygon({at(1, c), at(1, d), at(far, d), at(far, c)});
    }
  }
  b.polygon({{-1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {1, -1, -1}});
  b.polygon({{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}});
  return b.plc;
}

/// Two rectangles that meet in an edge at a small angle, closed by triangles and a rectangle; alone or in a box that is
/// meshed too.
PiecewiseLinearComplex wedge(double opening, bool in_box) {
  PlcBuilder b;
  const double l = 10, h = l * opening;
  if (in_box) b.box({-5, -5, -8}, {15, 15, 8});
  b.polygon({{0, 0, 0}, {0, l, 0}, {l, l, 0}, {l, 0, 0}});
  b.polygon({{0, 0, 0}, {l, 0, h}, {l, l, h}, {0, l, 0}});
  b.polygon({{l, 0, 0}, {l, l, 0}, {l, l, h}, {l, 0, h}});
  b.triangle({0, 0, 0}, {l, 0, 0}, {l, 0, h});
  b.triangle({0, l, 0}, {l, l, h}, {l, l, 0});
  return b.plc;
}

/// A layer of this angle that ends along a line in the side of a box, between two others; its sides and the box's are
/// coplanar.
PiecewiseLinearComplex layer_that_ends(double angle) {
  PlcBuilder b;
  const double low = 0.25, high = 0.25 + std::tan(angle);
  const auto at = [](double x, double y, double z) { return Vec3{x, y, z}; };
  b.polygon({at(0, 0, low), at(1, 0, low), at(1, 1, low), at(0, 1, low)});
  b.polygon({at(0, 0, low), at(1, 0, high), at(1, 1, high), at(0, 1, low)});
  b.polygon({at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0)});
  b.polygon({at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)});
  b.polygon({at(0, 0, 0), at(0, 0, low), at(0, 1, low), at(0, 1, 0)});
  b.polygon({at(0, 0, low), at(0, 0, 1), at(0, 1, 1), at(0, 1, low)});
  b.polygon({at(1, 0, 0), at(1, 1, 0), at(1, 1, low), at(1, 0, low)});
  b.polygon({at(1, 0, low), at(1, 1, low), at(1, 1, high), at(1, 0, high)});
  b.polygon({at(1, 0, high), at(1, 1, high), at(1, 1, 1), at(1, 0, 1)});
  for (const double y : {0.0, 1.0}) {
    b.polygon({at(0, y, 0), at(1, y, 0), at(1, y, low), at(0, y, low)});
    b.triangle(at(0, y, low), at(1, y, low), at(1, y, high));
    b.polygon({at(0, y, low), at(1, y, high), at(1, y, 1), at(0, y, 1)});
  }
  return b.plc;
}

/// Many sheets through one edge at equal small angles, in a box.
PiecewiseLinearComplex sheaf(int n, double angle) {
  PlcBuilder b;
  b.box({-5, -5, -8}, {15, 15, 8});
  for (int i = 0; i < n; ++i) {
    const double h = 10 * std::tan(i * angle);
    b.polygon({{0, 0, 0}, {10, 0, h}, {10, 10, h}, {0, 10, 0}});
  }
  return b.plc;
}

std::string number(double x) {
  std::string s = std::to_string(x);
  s.erase(s.find_last_not_of('0') + 1);
  if (s.back() == '.') s.pop_back();
  return s;
}

}  // namespace

std::vector<CorpusModel> corpus_polyhedra() {
  std::vector<CorpusModel> models;
  for (double twist : {5.0, 30.0, 45.0, 59.0, 59.99}) {
    models.push_back({"schonhardt_" + number(twist), 1, [twist] { return schonhardt_model(twist, false); }});
    models.push_back({"schonhardt_in_box_" + number(twist), 2, [twist] { return schonhardt_model(twist, true); }});
  }
  for (int n : {2, 4, 8, 16, 32})
    models.push_back({"chazelle_" + std::to_string(n), 1, [n] { return chazelle(n, 0.01); }, n > 4});
  for (int n : {2, 4, 8, 16, 32})
    models.push_back({"hanging_plates_" + std::to_string(n), 1, [n] { return hanging_plates(n); }, n > 4});
  models.push_back({"high_degree_vertex", 1, [] { return high_degree_vertex(30); }});
  models.push_back({"fan_of_segments", 1, [] { return fan_of_segments(30); }});
  models.push_back({"needle_bundle", 1, [] { return needle_bundle(30); }});
  for (double s : {0.5, 0.01})
    models.push_back({"pyramids_and_block_" + number(s), 9, [s] { return pyramids_and_block(s); }});
  models.push_back({"dodecahedron_icosahedron", 1,
                    [] { return read_plc(GEOMESH_SOURCE_DIR "/tests/corpus/dodecahedron_icosahedron.off"); }});
  int k = 0;
  for (double opening : {0.5773502691896257, 0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    const std::string name = k == 0 ? "30deg" : "1e-" + std::to_string(k);
    models.push_back({"wedge_" + name, 1, [opening] { return wedge(opening, false); }, false, opening > 1e-5});
    models.push_back({"wedge_in_box_" + name, 2, [opening] { return wedge(opening, true); }, false, opening > 1e-5});
    ++k;
  }
  for (const auto& [name, angle] : {std::pair{"30deg", 30 * degree}, {"1deg", degree}, {"1e-4", 1e-4}, {"1e-6", 1e-6}})
    models.push_back({std::string("layer_that_ends_") + name, 3, [angle = angle] { return layer_that_ends(angle); },
                      false, angle > 1e-5});
  models.push_back({"sheaf_1deg", 1, [] { return sheaf(20, degree); }});
  models.push_back({"sheaf_1e-4", 1, [] { return sheaf(20, 1e-4); }});
  return models;
}

}  // namespace geomesh::test
