// SPDX-License-Identifier: MIT
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>

#include "corpus_builder.hpp"
#include "corpus_models.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "plc/facet_triangulation.hpp"
#include "plc/find_crossing.hpp"

using namespace geomesh;

namespace {

ErrorKind kind_of_failure(const PiecewiseLinearComplex& plc) {
  try {
    tetrahedralize(plc);
  } catch (const Error& e) {
    return e.kind();
  }
  FAIL("an invalid model was meshed");
  return ErrorKind::usage;
}

PiecewiseLinearComplex box() {
  test::PlcBuilder b;
  b.box({0, 0, 0}, {1, 1, 1});
  return b.plc;
}

}  // namespace

TEST_CASE("structural faults of a PLC are all listed", "[plc]") {
  PiecewiseLinearComplex plc = box();
  plc.points[0].x = std::numeric_limits<double>::quiet_NaN();
  plc.points.push_back(plc.points[1]);
  plc.add_triangle({0, 1, 99});
  plc.add_triangle({0, 0, 1});
  CHECK(validate_plc(plc).size() >= 3);
  CHECK(validate_plc(box()).empty());
}

TEST_CASE("equal points, flat and repeated triangles are refused", "[plc]") {
  PiecewiseLinearComplex equal = box();
  equal.points.push_back(equal.points[3]);
  CHECK(kind_of_failure(equal) == ErrorKind::invalid_input);
  PiecewiseLinearComplex flat = box();
  flat.points.push_back({0.25, 0.25, 0.25});
  flat.points.push_back({0.5, 0.5, 0.5});
  flat.points.push_back({0.75, 0.75, 0.75});
  flat.add_triangle({8, 9, 10});
  CHECK(kind_of_failure(flat) == ErrorKind::invalid_input);
  PiecewiseLinearComplex twice = box();
  twice.points.push_back({0.5, 0.5, 0.5});
  twice.add_triangle({0, 1, 8});
  twice.add_triangle({1, 8, 0});
  CHECK(kind_of_failure(twice) == ErrorKind::invalid_input);
}

TEST_CASE("a triangle that two facets have is refused with both named", "[plc]") {
  PiecewiseLinearComplex twice = box();
  twice.points.push_back({0.5, 0.5, 0.5});
  const Index a = twice.add_triangle({0, 1, 8}), b = twice.add_triangle({1, 8, 0});
  try {
    tetrahedralize(twice);
    FAIL("the triangle was meshed");
  } catch (const Error& e) {
    CHECK(e.kind() == ErrorKind::invalid_input);
    CHECK(std::set<Index>(e.context().facets.begin(), e.context().facets.end()) == std::set<Index>{a, b});
  }
}

TEST_CASE("crossing facets are refused with both named", "[plc][recover]") {
  PiecewiseLinearComplex plc = box();
  const VertexIndex first = static_cast<VertexIndex>(plc.points.size());
  for (const Vec3& p : {Vec3{0.2, 0.2, 0.5}, Vec3{0.8, 0.2, 0.5}, Vec3{0.5, 0.8, 0.5}, Vec3{0.5, 0.3, 0.2},
                        Vec3{0.5, 0.4, 0.8}, Vec3{0.6, 0.5, 0.8}})
    plc.points.push_back(p);
  const Index a = plc.add_triangle({first, first + 1, first + 2}),
              b = plc.add_triangle({first + 3, first + 4, first + 5});
  CHECK(find_crossing(plc).has_value());
  CHECK_FALSE(find_crossing(box()).has_value());
  try {
    tetrahedralize(plc);
    FAIL("crossing facets were meshed");
  } catch (const Error& e) {
    CHECK(e.kind() == ErrorKind::invalid_input);
    CHECK(std::count(e.context().facets.begin(), e.context().facets.end(), a) == 1);
    CHECK(std::count(e.context().facets.begin(), e.context().facets.end(), b) == 1);
  }
}

TEST_CASE("an edge that ends on a point declared inside of a triangle crosses nothing", "[plc]") {
  // Found by seed 920971 of the random models (--light): a well ends on a side of the box that has three corners.
  PiecewiseLinearComplex plc;
  plc.points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {1, 1, -1}, {2, 1, 0}};
  const Index f = plc.add_triangle({0, 1, 2});
  plc.segments.push_back({3, 4});
  CHECK(find_crossing(plc).has_value());
  PiecewiseLinearComplex with_point = plc;
  with_point.facet_points.push_back({f, 3});
  CHECK_FALSE(find_crossing(with_point).has_value());
  PiecewiseLinearComplex with_segment = plc;
  with_segment.facet_segments.push_back({f, 3, 5});
  CHECK_FALSE(find_crossing(with_segment).has_value());
}

TEST_CASE("a vertex inside a facet or on a segment is refused", "[plc][recover]") {
  PiecewiseLinearComplex inside = box();
  inside.points.push_back({0, 0.3, 0.4});
  inside.isolated_points.push_back(8);
  CHECK(kind_of_failure(inside) == ErrorKind::invalid_input);
  PiecewiseLinearComplex on_edge = box();
  on_edge.points.push_back({0, 0, 0.5});
  on_edge.isolated_points.push_back(8);
  CHECK(kind_of_failure(on_edge) == ErrorKind::invalid_input);
}

TEST_CASE("an open surface encloses nothing", "[classify]") {
  PiecewiseLinearComplex plc;
  plc.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.5}};
  plc.add_triangle({0, 1, 2});
  plc.add_triangle({1, 3, 2});
  CHECK(kind_of_failure(plc) == ErrorKind::cannot_mesh);
}

TEST_CASE("hole seeds drop components, region seeds name them", "[classify]") {
  PiecewiseLinearComplex plc = test::corpus_model("cube_lattice_2").make();
  plc.hole_seeds.push_back({{0.4, 0.6, 0.3}, no_index});
  plc.region_seeds.push_back({{1.4, 1.6, 1.3}, 42});
  const auto mesh = tetrahedralize(plc);
  CHECK(mesh.n_components == 7);
  CHECK(std::count(mesh.component_seed.begin(), mesh.component_seed.end(), 42u) == 1);
}

TEST_CASE("a seed on a facet, an edge or a corner of one is refused, since it names no side", "[classify]") {
  for (const Vec3& place : {Vec3{1, 0.4, 0.3}, Vec3{1, 1, 0.3}, Vec3{1, 1, 1}, Vec3{0, 0.4, 0.3}}) {
    PiecewiseLinearComplex plc = test::corpus_model("cube_lattice_2").make();
    plc.hole_seeds.push_back({place, no_index});
    CHECK(kind_of_failure(plc) == ErrorKind::invalid_input);
    plc.region_seeds.swap(plc.hole_seeds);
    CHECK(kind_of_failure(plc) == ErrorKind::invalid_input);
  }
}

TEST_CASE("a facet with holes, an inner segment and a point is triangulated", "[plc]") {
  const std::vector<Vec3> points{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0},     {1, 1, 0},  {2, 1, 0},
                                 {2, 2, 0}, {1, 2, 0}, {3, 3, 0}, {3.5, 0.5, 0}, {3.5, 2, 0}};
  FacetPolygon polygon;
  polygon.loops = {{0, 1, 2, 3}, {4, 5, 6, 7}};
  polygon.segments = {{9, 10}};
  polygon.inner_points = {8};
  FacetFault fault;
  const auto t = triangulate_facet(points, polygon, fault);
  REQUIRE(t);
  CHECK(t->exactly_planar);
  double area = 0;
  for (const Triangle& f : t->triangles)
    area += 0.5 * cross(points[f[1]] - points[f[0]], points[f[2]] - points[f[0]]).z;
  CHECK(area == 15.0);
  polygon.segments = {{0, 2}};  // runs through the hole
  CHECK_FALSE(triangulate_facet(points, polygon, fault));
  CHECK(fault.vertices.size() >= 2);
}
