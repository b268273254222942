// SPDX-License-Identifier: MIT
// Shape measures against closed forms, statistics against counts by hand, causes on wedges and gaps of known angle and
// width.
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <random>

#include "geomesh/core/quality.hpp"
#include "quality/causes.hpp"
#include "quality/soup_star.hpp"
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
  std::vector<Index> rows(model.mesh.tetrahedra.size());
  std::iota(rows.begin(), rows.end(), Index{0});
  const std::vector<Index> unforced = unforced_bad_elements(model.mesh, {}, {}, rows);
  REQUIRE(unforced.size() == q.n_bad - q.n_bad_forced);
  for (std::size_t k = 0; k < unforced.size(); ++k) CHECK(unforced[k] == q.worst[k].tetrahedron);
}

namespace {

/// Points and faces by facet, for what looks at the input's parts alone.
ConstrainedTetrahedralization faces_of(std::vector<Vec3> points, const std::vector<std::pair<Triangle, Index>>& faces) {
  ConstrainedTetrahedralization mesh;
  mesh.input_vertex.assign(points.size(), no_vertex);
  mesh.points = std::move(points);
  for (const auto& [t, facet] : faces) mesh.faces.push_back({t, facet, no_index, no_index});
  return mesh;
}

/// One element, every facet a triangle of its own, sizes of 1 asked everywhere.
Model one_element(std::vector<Vec3> points, const Tetrahedron& cell, const std::vector<Triangle>& facets) {
  Model m;
  m.plc.points = m.mesh.points = std::move(points);
  for (VertexIndex v = 0; v < m.plc.points.size(); ++v) m.mesh.input_vertex.push_back(v);
  m.mesh.origin.assign(m.plc.points.size(), VertexOrigin::input);
  m.mesh.tetrahedra = {cell};
  m.mesh.component = {0};
  m.mesh.n_components = 1;
  for (const Triangle& t : facets) m.mesh.faces.push_back({t, m.plc.add_triangle(t), no_index, no_index});
  return m;
}

SizeField uniform(double size) {
  SizeField::Limits limits;
  limits.global = size;
  return SizeField({}, limits);
}

WorstElement explained(const Model& m, const QualityOptions& options) {
  const MeshQuality q = measure_quality(m.plc, m.mesh, options);
  REQUIRE(q.worst.size() == 1);
  return q.worst[0];
}

Model two_plates() {  // 0.01 apart, an element between them
  return one_element({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 0.01}, {2, 0.3, 0.01}, {0.3, 2, 0.01}}, {0, 1, 2, 3},
                     {{0, 1, 2}, {3, 4, 5}});
}

}  // namespace

TEST_CASE("How a facet is cut into faces makes no angle of the input", "[quality]") {
  // A facet of 90 degrees in two faces, of 3 and 87 degrees, and another that stands on it.
  const auto mesh = faces_of({{0, 0, 0}, {1, 0, 0}, {1, 0.05, 0}, {0, 1, 0}, {0, 0, -1}},
                             {{{0, 1, 2}, 0}, {{0, 2, 3}, 0}, {{0, 4, 1}, 1}});
  CHECK(SoupStars(mesh, {}).least_angle(0).degrees == Approx(90));
  // As facets of their own their sides do meet at 2.9 degrees.
  auto cut = mesh;
  cut.faces[1].facet = 2;
  CHECK(SoupStars(cut, {}).least_angle(0).degrees == Approx(std::atan(0.05) * 180 / std::acos(-1.0)));
  // Facets that are kept as one count as one.
  const std::vector<Index> patch{0, 1, 0};
  CHECK(SoupStars(cut, patch).least_angle(0).degrees == Approx(90));
}

TEST_CASE(
    "A crease of a surface that may be remeshed forces where the input has it, and not where remeshing has made it",
    "[quality]") {
  const auto height = [](double degrees) { return std::tan(degrees * std::acos(-1.0) / 180); };
  Model m = one_element({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 0, height(3)}}, {0, 1, 2, 3},
                        {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}});
  QualityOptions options;
  options.facet_patch = {0, 0, 0, 0};
  options.tolerance = 0.1;
  const WorstElement wedge = explained(m, options);
  CHECK(wedge.cause == ShapeCause::input_angle);
  CHECK(wedge.forcing_angle == Approx(3));
  // Moved by less than the tolerance, and by more.
  m.plc.points[0].x = m.plc.points[1].x = 0.09;
  CHECK(explained(m, options).cause == ShapeCause::input_angle);
  m.plc.points[0].x = m.plc.points[1].x = 0.11;
  CHECK(explained(m, options).cause == ShapeCause::free);
  m.plc.points[0].x = m.plc.points[1].x = 0;
  m.plc.points[3].z = height(20);
  CHECK(explained(m, options).cause == ShapeCause::free);
}

TEST_CASE("A side meets a facet, and a listed segment meets one, at the angle between them", "[quality]") {
  const double pi = std::acos(-1.0), t = 20 * pi / 180;
  const Vec3 side{std::cos(t), std::sin(t) * std::cos(t),
                  std::sin(t) * std::sin(t)};  // 20 degrees from x in a plane tilted by 20 degrees about x
  const auto mesh = faces_of({{0, 0, 0}, {1, 0, 0}, side, {0, 1, 0}}, {{{0, 1, 2}, 0}, {{0, 3, 1}, 1}});
  CHECK(SoupStars(mesh, {}).least_angle(0).degrees == Approx(std::asin(std::sin(t) * std::sin(t)) * 180 / pi));
  auto listed = faces_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.1}}, {{{0, 1, 2}, 0}});
  CHECK(SoupStars(listed, {}).least_angle(0).degrees == Approx(90));
  listed.edges.push_back({0, 3, 7});
  const MeetingAngle least = SoupStars(listed, {}).least_angle(0);
  CHECK(least.degrees == Approx(std::atan(0.1 / std::sqrt(2.0)) * 180 / pi));
  CHECK(least.segment_a == 7);
  CHECK(least.facet_b == 0);
}

TEST_CASE("A gap is compared with the size that was asked, and the tolerance says whether it could be closed",
          "[quality]") {
  const Model m = two_plates();
  const SizeField one = uniform(1), small = uniform(0.03);
  QualityOptions options;
  options.size = &small;
  CHECK(explained(m, options).cause == ShapeCause::free);
  options.asked = &one;
  const WorstElement w = explained(m, options);
  CHECK(w.cause == ShapeCause::thin_gap);
  CHECK(w.gap == Approx(0.01));
  CHECK(((w.facet_a == 0 && w.facet_b == 1) || (w.facet_a == 1 && w.facet_b == 0)));
  options.tolerance = 0.004;
  CHECK(explained(m, options).cause == ShapeCause::thin_gap);
  options.tolerance = 0.006;
  CHECK(explained(m, options).cause == ShapeCause::free);
}

TEST_CASE("Surfaces on one wall have a gap between them, a hollow of one surface has none", "[quality]") {
  const SizeField one = uniform(1);
  QualityOptions options;
  options.size = &one;
  // Two plates 0.01 apart that end on the wall y = 0: vertices 0, 1 and 3 are on it.
  const Model on_wall =
      one_element({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 0, 0.01}, {1.5, 0, 0.01}, {0.5, 1, 0.01}, {0.5, 0, -1}},
                  {0, 1, 2, 3}, {{0, 1, 2}, {3, 4, 5}, {0, 6, 1}, {0, 3, 1}, {3, 4, 1}});
  CHECK(explained(on_wall, options).cause != ShapeCause::free);
  // Four points of the bowl z = 0.02 (x^2 + y^2), their facets about them, the element inside the bowl.
  const auto at = [](double x, double y) { return Vec3{x, y, 0.02 * (x * x + y * y)}; };
  const Model bowl = one_element({at(-1, 0), at(1, 0), at(0, -1.1), at(0, 1.1), at(-2, 1), at(-2, -1), at(2, -1),
                                  at(2, 1), at(1, -2), at(-1, -2), at(1, 2), at(-1, 2)},
                                 {0, 1, 3, 2}, {{0, 4, 5}, {1, 6, 7}, {2, 9, 8}, {3, 10, 11}});
  CHECK(orient3d(bowl.mesh.points[0], bowl.mesh.points[1], bowl.mesh.points[3], bowl.mesh.points[2]) == Sign::positive);
  CHECK(explained(bowl, options).min_dihedral < 8);
  CHECK(explained(bowl, options).cause == ShapeCause::free);
}

TEST_CASE("A vertex of the input near the side of a facet leaves a gap", "[quality]") {
  // The end 3 of a segment, 0.05 beside the side 0-1 of a facet; the element has the edge between them and no other
  // vertex on the input.
  Model m = one_element(
      {{-1, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0.05, 0}, {0, 0.05, -1}, {0, 0, 0}, {0.6, 0.4, 0.05}, {-0.6, 0.4, 0.05}},
      {3, 5, 6, 7}, {{0, 5, 3}, {5, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  for (auto& f : m.mesh.faces) f.facet = 0;
  m.mesh.edges.push_back({3, 4, 0});
  const SizeField one = uniform(1);
  QualityOptions options;
  options.size = &one;
  options.bad_angle = 90;
  const WorstElement w = explained(m, options);
  CHECK(w.cause == ShapeCause::thin_gap);
  CHECK(w.gap == Approx(0.05));
}

TEST_CASE("A gap between two segments is as wide as between these, however they were cut by points", "[quality]") {
  // A strip of one facet, 0.02 wide; the element has the diagonal 0-5 of one of its pieces. Points 4 and 9 cut both
  // sides near its ends, so that what is nearest to each of its vertices is not on the pieces of the side that the
  // other is on.
  Model m = one_element({{0, 0, 0},
                         {1, 0, 0},
                         {-1, 0, 0},
                         {-1, 0.02, 0},
                         {0.05, 0.02, 0},
                         {0.5, 0.02, 0},
                         {0.2, -0.3, 0.4},
                         {1, 0.02, 0},
                         {0.3, 0.2, 0.405},
                         {0.45, 0, 0}},
                        {0, 5, 8, 6}, {{2, 0, 4}, {2, 4, 3}, {0, 5, 4}, {0, 9, 5}, {9, 1, 5}, {1, 7, 5}});
  for (auto& f : m.mesh.faces) f.facet = 0;
  for (const VertexIndex added : {0, 4, 5, 6, 8, 9}) m.mesh.input_vertex[added] = no_vertex;
  const SizeField one = uniform(1);
  QualityOptions options;
  options.size = &one;
  options.bad_angle = 90;
  const WorstElement w = explained(m, options);
  CHECK(w.cause == ShapeCause::thin_gap);
  CHECK(w.gap == Approx(0.02));
  // Two points of one segment have no gap between them: with 0 and 1 in the element, and nothing else of the input.
  m.mesh.tetrahedra[0] = {0, 1, 8, 6};
  CHECK(explained(m, options).cause == ShapeCause::free);
  // Nor is there one where both segments turn away.
  m.mesh.tetrahedra[0] = {0, 5, 8, 6};
  m.mesh.points[4].y = 0.3, m.mesh.points[9].y = -0.3;
  CHECK(explained(m, options).cause == ShapeCause::free);
}

TEST_CASE("The shape of a needle is told from its short edges", "[quality]") {
  // Three corners as near to each other as doubles are, and one 100 m away: seen from that one rounding is all there
  // is.
  const double delta = std::ldexp(1.0, -42);
  const Vec3 o{1000.25, 2000.5, -500};
  const std::array<Vec3, 4> p{o, o + Vec3{delta, 0, 0}, o + Vec3{0, delta, 0}, o + Vec3{0, 0, 100}};
  constexpr std::array<std::array<unsigned, 4>, 4> orders{{{0, 1, 2, 3}, {3, 1, 0, 2}, {1, 3, 0, 2}, {2, 3, 1, 0}}};
  for (const auto& at : orders) {
    std::array<Vec3, 4> q{p[at[0]], p[at[1]], p[at[2]], p[at[3]]};
    if (orient3d(q[0], q[1], q[2], q[3]) != Sign::positive) std::swap(q[2], q[3]);
    const TetrahedronShape s = tetrahedron_shape(q[0], q[1], q[2], q[3]);
    CHECK(s.volume == Approx(delta * delta * 100 / 6).epsilon(1e-9));
    CHECK(s.min_dihedral == Approx(45).epsilon(1e-9));
    CHECK(s.max_dihedral == Approx(90).epsilon(1e-9));
    // Inscribed in a prism about the triangle, in a circle about the length.
    CHECK(s.radius_ratio == Approx(3 * delta * (1 - std::sqrt(0.5)) / 50).epsilon(1e-6));
    for (unsigned e = 0; e < 6; ++e) {
      const auto [i, j] = edge_vertices[e];
      const Vec3 way = q[j] - q[i];
      const bool is_long = dot(way, way) > 1;
      CHECK((is_long || std::abs(s.dihedral[e] - 90) < 1e-6));
    }
  }
}

TEST_CASE("Ratios of needles are never above 1", "[quality]") {
  std::mt19937 random(7);
  const auto ulps = [&] { return std::ldexp(static_cast<double>(random() % 5), -43); };
  for (int k = 0; k < 20000; ++k) {
    const Vec3 o{362, 629, -102}, far{318 + random() / 4e9, 640 + random() / 4e9, -141 + random() / 4e9};
    std::array<Vec3, 4> q{far, o, o, o};
    for (unsigned i = 1; i < 4; ++i) q[i] = o + Vec3{ulps(), ulps(), ulps()};
    if (orient3d(q[0], q[1], q[2], q[3]) == Sign::negative) std::swap(q[2], q[3]);
    if (orient3d(q[0], q[1], q[2], q[3]) != Sign::positive) continue;
    const TetrahedronShape s = tetrahedron_shape(q[0], q[1], q[2], q[3]);
    CHECK(s.volume > 0);
    CHECK((s.radius_ratio >= 0 && s.radius_ratio < 1e-6));
    CHECK((s.mean_ratio >= 0 && s.mean_ratio < 1e-3));
    CHECK(s.min_dihedral < 75);
  }
}
