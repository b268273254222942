// SPDX-License-Identifier: MIT
// Shape measures against closed forms, statistics against counts by hand, causes on wedges and gaps of known angle and width.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "geomesh/core/quality.hpp"
#include "quality/shape.hpp"
#include "refine_models.hpp"

using namespace geomesh;
using namespace refine_models;

namespace {

const std::array<Vec3, 4> regular{Vec3{1, 1, 1}, Vec3{1, -1, -1}, Vec3{-1, -1, 1}, Vec3{-1, 1, -1}};

TetrahedronShape shape_of(const std::array<Vec3, 4>& p) {
  return orient3d(p[0], p[1], p[2], p[3]) == Sign::positive ? tetrahedron_shape(p[0], p[1], p[2], p[3])
                                                            : tetrahedron_shape(p[0], p[1], p[3], p[2]);
}

}  // namespace

TEST_CASE("The regular tetrahedron has angle arccos 1/3 and ratios 1", "[quality]") {
  const TetrahedronShape s = shape_of(regular);
  for (const double a : s.dihedral) CHECK(a == Approx(70.528779365509308));
  for (const double a : s.solid_angle) CHECK(a == Approx(31.586338096527));
  CHECK(s.radius_ratio == Approx(1));
  CHECK(s.aspect == Approx(1));
  CHECK(s.mean_ratio == Approx(1));
  CHECK(s.volume == Approx(8.0 / 3));
  CHECK(s.shortest_edge == Approx(std::sqrt(8.0)));
}

TEST_CASE("The corner of a cube has three right angles", "[quality]") {
  const TetrahedronShape s = tetrahedron_shape({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  CHECK(s.max_dihedral == Approx(90));
  CHECK(s.min_dihedral == Approx(std::acos(1 / std::sqrt(3.0)) * 180 / std::acos(-1.0)));
  CHECK(s.solid_angle[0] == Approx(90));
  CHECK(s.volume == Approx(1.0 / 6));
}

TEST_CASE("A flat tetrahedron has angles 0 and 180 and ratios 0", "[quality]") {
  const TetrahedronShape s = tetrahedron_shape({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  CHECK(s.min_dihedral == 0);
  CHECK(s.max_dihedral == 180);
  CHECK(s.radius_ratio == 0);
}

TEST_CASE("The measure of improvement is the least weighted sine, its gradient that of differences", "[quality]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(-0.4, 0.4);
  for (int trial = 0; trial < 200; ++trial) {
    std::array<Vec3, 4> p = regular;
    for (Vec3& q : p) q = q + Vec3{u(random), u(random), u(random)};
    if (orient3d(p[0], p[1], p[2], p[3]) != Sign::positive) std::swap(p[0], p[1]);
    const TetrahedronShape s = tetrahedron_shape(p[0], p[1], p[2], p[3]);
    double expected = 1;
    for (const double a : s.dihedral)
      expected = std::min(expected, std::sin(a * std::acos(-1.0) / 180) * (a > 90 ? remesh::obtuse_weight : 1));
    CHECK(remesh::shape(p[0], p[1], p[2], p[3]) == Approx(expected));
    const remesh::detail::ShapeFrame frame(p[0], p[1], p[2], p[3]);
    const auto terms = remesh::shape_terms(frame, p[0], p[1], p[2]);
    for (unsigned k = 0; k < 6; ++k) {
      const Vec3 g = remesh::shape_gradient(frame, k, terms.value[k]);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        constexpr double h = 1e-6;
        Vec3 forward = p[3], back = p[3];
        forward[axis] += h;
        back[axis] -= h;
        const double f = remesh::shape_terms(remesh::detail::ShapeFrame(p[0], p[1], p[2], forward), p[0], p[1], p[2]).value[k];
        const double b = remesh::shape_terms(remesh::detail::ShapeFrame(p[0], p[1], p[2], back), p[0], p[1], p[2]).value[k];
        if (std::abs(f - b) < 0.1)  // not across the step of the weight at 90 degrees
          CHECK(g[axis] == Approx((f - b) / (2 * h)).margin(1e-5));
      }
    }
  }
}

TEST_CASE("Statistics count every element, angle and edge", "[quality]") {
  const Model model = two_boxes(2);
  SizeField::Limits limits;
  limits.global = 0.25;
  const SizeField size({}, limits);
  QualityOptions options;
  options.size = &size;
  const MeshQuality q = measure_quality(model.plc, model.mesh, options);
  const std::size_t n = model.mesh.tetrahedra.size();
  CHECK(q.whole.n_tetrahedra == n);
  CHECK(q.whole.volume == Approx(1));
  std::size_t angles = 0, edges = 0, elements = 0;
  for (const std::size_t c : q.whole.dihedral_histogram) angles += c;
  for (const std::size_t c : q.whole.edge_size_histogram) edges += c;
  for (const auto& part : q.per_component) elements += part.n_tetrahedra;
  CHECK(angles == 6 * n);
  CHECK(elements == n);
  CHECK(q.per_component.size() == 2);
  CHECK(q.whole.min_dihedral.min == Approx(45));
  CHECK(q.whole.max_dihedral.max == Approx(90));
  CHECK(q.whole.share_above_24_85 == 1);
  CHECK(q.whole.edge_length.min == Approx(0.25));
  CHECK(q.whole.edge_length.max == Approx(0.25 * std::sqrt(3.0)));
  CHECK(edges > 0);
  CHECK(q.worst.empty());
  const ShapeStatistics plain = measure_shapes(model.mesh.points, model.mesh.tetrahedra);
  CHECK(plain.min_dihedral.mean == q.whole.min_dihedral.mean);
}

TEST_CASE("A wedge of 3 degrees between two facets is named as the cause", "[quality]") {
  Model m;
  const double t = std::tan(3 * std::acos(-1.0) / 180);
  m.plc.points = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 0, t}};
  m.mesh.points = m.plc.points;
  m.mesh.input_vertex = {0, 1, 2, 3};
  m.mesh.origin.assign(4, VertexOrigin::input);
  Tetrahedron cell{0, 1, 2, 3};
  if (orient3d(m.mesh.points[0], m.mesh.points[1], m.mesh.points[2], m.mesh.points[3]) != Sign::positive)
    std::swap(cell[2], cell[3]);
  m.mesh.tetrahedra = {cell};
  m.mesh.component = {0};
  m.mesh.n_components = 1;
  for (const auto& f : face_vertices) {
    const Triangle face{cell[f[0]], cell[f[1]], cell[f[2]]};
    m.mesh.faces.push_back({face, m.plc.add_triangle(face), no_index, 0});
  }
  const MeshQuality q = measure_quality(m.plc, m.mesh);
  REQUIRE(q.worst.size() == 1);
  CHECK(q.n_bad_forced == 1);
  CHECK(q.worst[0].cause == ShapeCause::input_angle);
  CHECK(q.worst[0].min_dihedral == Approx(3));
  CHECK(q.worst[0].forcing_angle <= 3.0 + 1e-9);
}

TEST_CASE("A sliver that nothing forces is listed first and as free", "[quality]") {
  Model model = two_boxes(2);
  // Squeeze one inner vertex towards a neighbour.
  for (VertexIndex v = 0; v < model.mesh.points.size(); ++v)
    if (model.mesh.input_vertex[v] == no_vertex) {
      model.mesh.points[v].x += 0.24;
      break;
    }
  const MeshQuality q = measure_quality(model.plc, model.mesh);
  REQUIRE(q.n_bad > 0);
  CHECK(q.worst[0].cause == ShapeCause::free);
  CHECK(q.n_bad_forced < q.n_bad);
}

TEST_CASE("An element across a gap thinner than a quarter of the size is told so", "[quality]") {
  // Two facets that share no vertex, 0.01 apart, and an element between them.
  Model m;
  m.plc.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 0.01}, {2, 0.3, 0.01}, {0.3, 2, 0.01}};
  m.mesh.points = m.plc.points;
  m.mesh.input_vertex = {0, 1, 2, 3, 4, 5};
  m.mesh.origin.assign(6, VertexOrigin::input);
  m.mesh.tetrahedra = {{0, 1, 2, 3}};
  m.mesh.component = {0};
  m.mesh.n_components = 1;
  m.mesh.faces.push_back({{0, 1, 2}, m.plc.add_triangle({0, 1, 2}), no_index, 0});
  m.mesh.faces.push_back({{3, 4, 5}, m.plc.add_triangle({3, 4, 5}), no_index, no_index});
  SizeField::Limits limits;
  limits.global = 1;
  const SizeField size({}, limits);
  QualityOptions options;
  options.size = &size;
  const MeshQuality q = measure_quality(m.plc, m.mesh, options);
  REQUIRE(q.worst.size() == 1);
  CHECK(q.worst[0].cause == ShapeCause::thin_gap);
  CHECK(q.worst[0].gap == Approx(0.01));
}
