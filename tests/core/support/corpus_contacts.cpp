// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "corpus_builder.hpp"
#include "corpus_models.hpp"

namespace geomesh::test {

namespace {

/// Two triangles `gap` apart at coordinates near `offset`, in a box.
PiecewiseLinearComplex near_triangles(double gap, double offset) {
  PlcBuilder b;
  const auto at = [&](double x, double y, double z) { return Vec3{offset + x, offset + y, offset + z}; };
  b.box(at(-4, -4, -4), at(8, 8, 8));
  const auto on_plane = [&](double x, double y, double above) { return at(x, y, x / 4 + y / 8 + above); };
  b.triangle(on_plane(0, 0, 0), on_plane(3, 0.5, 0), on_plane(1, 2.5, 0));
  b.triangle(on_plane(0.25, -0.125, gap), on_plane(3.5, 0.25, gap), on_plane(0.5, 3, gap));
  return b.plc;
}

/// Two triangles `gap` apart in planes of constant z, at coordinates of 1e4, in a small box.
PiecewiseLinearComplex parallel_triangles(double gap) {
  PlcBuilder b;
  b.box({9999, 9999, 9999}, {10001, 10001, 10001});
  for (const double z : {10000.0, 10000 + gap})
    b.triangle({9999.5, 9999.5, z}, {10000.5, 9999.6, z}, {10000, 10000.5, z});
  return b.plc;
}

/// Spheres of the same triangulation, 0.2 apart.
PiecewiseLinearComplex thin_shells(unsigned level, int n) {
  PlcBuilder b;
  for (int i = 0; i < n; ++i) add_shell(b, sphere({0, 0, 0}, 1 - 0.2 * i, level));
  return b.plc;
}

PiecewiseLinearComplex nested_spheres(unsigned level, int n) {
  PlcBuilder b;
  for (int i = 0; i < n; ++i) add_shell(b, sphere({0, 0, 0}, 1.0 + i, level));
  return b.plc;
}

/// A sphere about the origin made smaller about its vertex (x, 0, 0), and slimmer than that, so that it touches at that
/// vertex alone.
Shell shrunk_about_vertex(const Shell& shell, double x) {
  Shell inner = shell;
  for (Vec3& p : inner.points) p = {x + 0.5 * (p.x - x), 0.25 * p.y, 0.25 * p.z};
  return inner;
}

PiecewiseLinearComplex spheres_touching_at_points(unsigned level) {
  PlcBuilder b;
  const Shell outer = sphere({0, 0, 0}, 2, level);
  add_shell(b, outer);
  add_shell(b, shrunk_about_vertex(outer, 2));
  Shell beside = outer;  // mirrored in the plane that touches at the vertex of greatest x
  for (Vec3& p : beside.points) p.x = 4 - p.x;
  for (Triangle& t : beside.triangles) std::swap(t[0], t[1]);
  add_shell(b, beside);
  return b.plc;
}

/// Two coarse balls that share an upright edge, the second the first mirrored; a tetrahedron inside the first shares
/// its opposite edge.
PiecewiseLinearComplex spheres_touching_along_edge() {
  PlcBuilder b;
  Shell ball;
  ball.points = {{2, 0, -1}, {2, 0, 1},   {0, 2, -1}, {0, 2, 1}, {-2, 0, -1},
                 {-2, 0, 1}, {0, -2, -1}, {0, -2, 1}, {0, 0, 2}, {0, 0, -2}};
  for (VertexIndex i = 0; i < 8; i += 2) {
    const VertexIndex k = (i + 2) % 8;
    ball.triangles.push_back({i, k, k + 1});
    ball.triangles.push_back({i, k + 1, i + 1});
    ball.triangles.push_back({i + 1, k + 1, 8});
    ball.triangles.push_back({k, i, 9});
  }
  add_shell(b, ball);
  Shell mirrored = ball;
  for (Vec3& p : mirrored.points) p.x = 4 - p.x;
  for (Triangle& t : mirrored.triangles) std::swap(t[0], t[1]);
  add_shell(b, mirrored);
  Shell inner;
  inner.points = {{-2, 0, -1}, {-2, 0, 1}, {0, 1, 0}, {0, -1, 0}};
  inner.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 2, 3}, {1, 3, 2}};
  add_shell(b, inner);
  return b.plc;
}

/// Two octahedra that share a vertex, and apart from them two tetrahedra that share an edge.
PiecewiseLinearComplex touching_solids() {
  PlcBuilder b;
  add_shell(b, sphere({0, 0, 0}, 1, 0));
  add_shell(b, sphere({2, 0, 0}, 1, 0));
  const Vec3 p{10, 0, 0}, q{10, 0, 2};
  for (const double side : {1.0, -1.0}) {
    const Vec3 r{10 + side, -0.5, 1}, s{10 + side, 0.5, 1};
    b.triangle(p, q, r);
    b.triangle(p, q, s);
    b.triangle(p, r, s);
    b.triangle(q, r, s);
  }
  return b.plc;
}

/// Two triangles that hang by an oblique inner segment of the floor and are not coplanar.
PiecewiseLinearComplex bent_hanging_facet() {
  PlcBuilder b;
  const Index floor = b.box({0, 0, 0}, {4, 4, 4});
  const Vec3 p{1, 1.5, 0}, q{3, 2.2, 0}, r{2.9, 2.1, 3}, s{1.2, 1.5, 2.5};
  b.facet_segment(floor, p, q);
  b.triangle(p, q, r);
  b.triangle(p, r, s);
  return b.plc;
}

/// A well with vertices close about it, so that it is missing at first.
PiecewiseLinearComplex well_among_points() {
  PlcBuilder b;
  b.box({0, 0, 0}, {4, 4, 4});
  b.segment({1, 1, 3.5}, {3, 2.5, 0.5}, 7);
  b.isolated_point({2, 3, 2});
  for (int i = 0; i < 12; ++i) {
    const double t = (i + 0.5) / 12, angle = 2.4 * i;
    b.isolated_point(Vec3{1, 1, 3.5} + t * Vec3{2, 1.5, -3} + Vec3{0.01 * std::cos(angle), 0.01 * std::sin(angle), 0});
  }
  return b.plc;
}

/// A facet that hangs in the region by one edge, which is an inner segment of the floor; another by a part of a box
/// edge.
PiecewiseLinearComplex hanging_facets() {
  PlcBuilder b;
  const Vec3 p{2, 5, 0}, q{8, 5, 0}, r{0, 0, 3}, s{0, 0, 6};
  const Index floor = b.polygon({{0, 0, 0}, {0, 10, 0}, {10, 10, 0}, {10, 0, 0}});
  b.facet_segment(floor, p, q);
  b.polygon({{0, 0, 10}, {10, 0, 10}, {10, 10, 10}, {0, 10, 10}});
  b.polygon({{0, 0, 0}, {10, 0, 0}, {10, 0, 10}, {0, 0, 10}, s, r});
  b.polygon({{10, 0, 0}, {10, 10, 0}, {10, 10, 10}, {10, 0, 10}});
  b.polygon({{10, 10, 0}, {0, 10, 0}, {0, 10, 10}, {10, 10, 10}});
  b.polygon({{0, 10, 0}, {0, 0, 0}, r, s, {0, 0, 10}, {0, 10, 10}});
  b.polygon({p, q, {8, 5.5, 4}, {2, 5.5, 4}});
  b.triangle(r, s, {4, 2, 5});
  return b.plc;
}

PiecewiseLinearComplex wells_and_points() {
  PlcBuilder b;
  b.box({0, 0, 0}, {10, 10, 10});
  b.segment({5, 5, 9}, {5, 5, 1}, 7);
  b.segment({2, 2, 1}, {8, 6, 2}, 8);
  b.segment({8, 6, 2}, {8, 6, 2.5}, 8);
  b.isolated_point({1, 1, 1});
  b.isolated_point({5, 5.00001, 5});
  return b.plc;
}

/// A floor with two holes, inner segments and an inner point; a pillar stands in one hole, the other is the bottom of a
/// shaft that is open to the room above the plate; the plate has the same holes.
PiecewiseLinearComplex polygons_with_holes() {
  PlcBuilder b;
  const auto square = [](double x, double y, double side, double z) {
    return std::vector<Vec3>{{x, y, z}, {x + side, y, z}, {x + side, y + side, z}, {x, y + side, z}};
  };
  const std::vector<std::vector<Vec3>> floor{square(0, 0, 10, 0), square(1, 1, 2, 0), square(6, 6, 3, 0)};
  const std::vector<std::vector<Vec3>> plate{square(0, 0, 10, 4), square(1, 1, 2, 4), square(6, 6, 3, 4)};
  const Index f = b.polygon_with_holes(floor);
  b.polygon_with_holes(plate);
  b.facet_segment(f, {4, 1, 0}, {5, 9, 0});
  b.facet_segment(f, {4, 1, 0}, {9, 3, 0});
  b.facet_point(f, {8, 2, 0});
  b.polygon(square(1, 1, 2, 0));
  b.polygon(square(1, 1, 2, 4));
  b.polygon(square(6, 6, 3, 0));
  b.polygon(square(0, 0, 10, 10));
  const auto walls = [&](double x, double y, double side, double low, double high) {
    const auto lower = square(x, y, side, low), upper = square(x, y, side, high);
    for (std::size_t i = 0; i < 4; ++i) b.polygon({lower[i], lower[(i + 1) % 4], upper[(i + 1) % 4], upper[i]});
  };
  walls(0, 0, 10, 0, 4);
  walls(0, 0, 10, 4, 10);
  walls(1, 1, 2, 0, 4);
  walls(6, 6, 3, 0, 4);
  return b.plc;
}

}  // namespace

std::vector<CorpusModel> corpus_contacts() {
  return {
      {"near_triangles_1e-7", 1, [] { return near_triangles(1e-7, 1e4); }, false, false},
      {"near_triangles_1e-3", 1, [] { return near_triangles(1e-3, 1e4); }},
      {"nested_spheres", 3, [] { return nested_spheres(2, 3); }},
      {"nested_spheres_fine", 4, [] { return nested_spheres(4, 4); }, true},
      {"spheres_touching_at_points", 3, [] { return spheres_touching_at_points(2); }},
      {"spheres_touching_along_edge", 3, [] { return spheres_touching_along_edge(); }},
      {"hanging_facets", 1, [] { return hanging_facets(); }},
      {"wells_and_points", 1, [] { return wells_and_points(); }},
      {"parallel_triangles_1e-7", 1, [] { return parallel_triangles(1e-7); }, false, false},
      {"thin_shells", 3, [] { return thin_shells(3, 3); }},
      {"touching_solids", 4, [] { return touching_solids(); }},
      {"bent_hanging_facet", 1, [] { return bent_hanging_facet(); }},
      {"well_among_points", 1, [] { return well_among_points(); }},
      {"polygons_with_holes", 3, [] { return polygons_with_holes(); }},
  };
}

}  // namespace geomesh::test
