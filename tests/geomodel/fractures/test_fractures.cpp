// SPDX-License-Identifier: GPL-3.0-or-later
// Fractures read from files and drawn from distributions.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <numbers>

#include "fractures/crossings.hpp"
#include "fractures/generate.hpp"
#include "fractures/plane_polygons.hpp"
#include "fractures/read_fractures.hpp"
#include "geomesh/core/error.hpp"
#include "scratch.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;

namespace {

std::vector<Fracture> read(const std::string& text, const FractureFileOptions& options = {}) {
  const auto path = scratch_folder() / "network.csv";
  std::ofstream(path) << text;
  return read_fracture_file(path, options);
}

Vec3 normal(const std::vector<Vec3>& polygon) {
  const Vec3 n = cross(polygon[1] - polygon[0], polygon[2] - polygon[0]);
  return (1 / std::sqrt(dot(n, n))) * n;
}

Box3 cube(double size) {
  Box3 box;
  box.add({0, 0, 0});
  box.add({size, size, size});
  return box;
}

}  // namespace

TEST_CASE("polygons as PorePy writes them are read, with and without the domain", "[fractures]") {
  const std::string corners = "0,0,0,1,0,0,1,1,0,0,1,0\n0.5,0,-1,0.5,1,-1,0.5,1,1\n";
  for (const std::string& domain : {std::string(), std::string("# bounds\n-1,-1,-1,2,2,2\n")}) {
    const std::vector<Fracture> found = read(domain + corners);
    REQUIRE(found.size() == 2);
    CHECK(found[0].corners == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    CHECK(found[1].corners.size() == 3);
    CHECK(found[1].name == "fracture_2");
    CHECK(area_of(found[0].corners) == 1);
  }
}

TEST_CASE("ellipses as PorePy writes them lie in their plane with their axes", "[fractures]") {
  FractureFileOptions options;
  options.layout = FractureFileOptions::Layout::ellipses;
  options.degrees = true;
  // Strike along x, dip 90 degrees: the plane y = 2, the major axis along x.
  const std::vector<Fracture> found = read("1,2,3,4,2,0,0,90,32\n1,2,3,4,2,0,0,0\n", options);
  REQUIRE(found.size() == 2);
  CHECK(found[0].corners.size() == 32);
  CHECK(found[1].corners.size() == 16);
  double far_x = 0, far_z = 0;
  for (const Vec3& p : found[0].corners) {
    CHECK(p.y == Approx(2));
    far_x = std::max(far_x, std::abs(p.x - 1));
    far_z = std::max(far_z, std::abs(p.z - 3));
  }
  CHECK(far_x == Approx(4));
  CHECK(far_z == Approx(2));
  for (const Vec3& p : found[1].corners) CHECK(p.z == Approx(3));
}

TEST_CASE("polygons as dfnWorks writes them are read", "[fractures]") {
  const std::vector<Fracture> found =
      read("nPolygons: 2\n3 {0, 0, 0} {1, 0, 0} {0, 1, 0}\n4 {0, 0, 1} {1, 0, 1} {1, 1, 1} {0, 1, 1}\n");
  REQUIRE(found.size() == 2);
  CHECK(found[0].corners.size() == 3);
  CHECK(found[1].corners[2] == Vec3{1, 1, 1});
}

TEST_CASE("a table of discs has the dip and the area that it states", "[fractures]") {
  const std::vector<Fracture> found = read("name,x,y,z,radius,dip_direction,dip\nA,10,20,-30,5,90,60\n");
  REQUIRE(found.size() == 1);
  CHECK(found[0].name == "A");
  CHECK(area_of(found[0].corners) == Approx(std::numbers::pi * 25));
  // Dipping to the east: the pole points up and to the east.
  const Vec3 n = normal(found[0].corners);
  const double up = n.z > 0 ? 1 : -1;
  CHECK(up * n.x == Approx(std::sin(std::numbers::pi / 3)));
  CHECK(n.y == Approx(0).margin(1e-12));
}

TEST_CASE("fractures that cannot be are refused with file, line and reason", "[fractures]") {
  using Catch::Contains;
  CHECK_THROWS_WITH(read("0,0,0,1,0,0,1,1,0,0,1,0.5\n"),
                    Contains("network.csv:1") && Contains("not plane") && Contains("near ("));
  CHECK_THROWS_WITH(read("0,0,0,1,0,0,2,0,0\n"), Contains("on a line"));
  CHECK_THROWS_WITH(read("0,0,0,1,0,0,1\n"), Contains("three corners or more"));
  CHECK_THROWS_WITH(read("# none\n"), Contains("holds no fracture"));
  CHECK_THROWS_WITH(read("x,y,z,radius,dip\n1,2,3,4,5\n"), Contains("dip_direction"));
  CHECK_THROWS_WITH(read("x,y,z,radius,dip_direction,dip\n1,2,3,-4,5,6\n"), Contains("above zero"));
  CHECK_THROWS_WITH(read("0,0,0,1,nan,0,1,1,0\n"), Contains("network.csv:1"));
}

TEST_CASE("drawn families reach their density, keep their radii and scatter as Fisher says", "[fractures]") {
  FractureFamily family;
  family.name = "steep";
  family.dip_direction = 90;
  family.dip = 80;
  family.kappa = 30;
  family.least_radius = 2;
  family.greatest_radius = 20;
  family.exponent = 2.5;
  family.p32 = 0.5;
  const Box3 box = cube(100);
  const std::vector<Fracture> found = generate_fractures({family}, box, 24, 9);
  double area = 0, sum_of_cosines = 0;
  const auto [strike, dip] = axes_of_plane(90, 80);
  const Vec3 mean = cross(dip, strike);
  for (const Fracture& f : found) {
    area += area_of(clipped(f.corners, box));
    const double radius = std::sqrt(area_of(f.corners) / std::numbers::pi);
    CHECK(radius > 2 - 1e-9);
    CHECK(radius < 20 + 1e-9);
    sum_of_cosines += std::abs(dot(normal(f.corners), mean));
  }
  CHECK(area / 1e6 >= 0.5);
  CHECK(area / 1e6 < 0.5 + std::numbers::pi * 400 / 1e6);
  // The mean cosine is coth(kappa) - 1 / kappa; its error is about 0.03 over the root of the count.
  CHECK(sum_of_cosines / static_cast<double>(found.size()) == Approx(1 - 1.0 / 30).margin(0.005));
  CHECK(generate_fractures({family}, box, 24, 9)[7].corners == found[7].corners);
  CHECK(generate_fractures({family}, box, 24, 10)[7].corners != found[7].corners);
}

TEST_CASE("a family that needs too many discs is refused before one is drawn", "[fractures]") {
  FractureFamily family{"f", 90, 80, 20, 100, 300, 2.5, 1e-5, 0};
  const Box3 box = cube(1000);
  const auto refused = [&](double FractureFamily::*key, double value, const char* words) {
    FractureFamily changed = family;
    changed.*key = value;
    CHECK_THROWS_WITH(generate_fractures({changed}, box, 8, 7),
                      Catch::Matchers::Contains(words) && Catch::Matchers::Contains("(family f)"));
  };
  refused(&FractureFamily::least_radius, 1e-30, "cannot be distinguished from a point");
  refused(&FractureFamily::least_radius, 1e-3, "needs about");
  refused(&FractureFamily::greatest_radius, 1e30, "hardly a disc meets it");
  refused(&FractureFamily::exponent, -1e300, "no mean area");
  refused(&FractureFamily::p32, 1e3, "more than 200,000");
  family.p32 = 0;
  family.count = 3;
  refused(&FractureFamily::greatest_radius, 1e30, "hardly a disc meets it");
  refused(&FractureFamily::least_radius, 5e-324, "cannot be distinguished from a point");
  CHECK(generate_fractures({family}, box, 8, 7).size() == 3);
  // Just below the limit by the mean area, whatever the exponent: the discs are drawn.
  family.count = 0;
  for (const double exponent : {0.0, 1.0, 2.0, 2.5, 3.5}) {
    family = {"f", 90, 80, 20, 4, 40, exponent, 0.01, 0};
    const std::size_t n = generate_fractures({family}, box, 8, 7).size();
    family.p32 = 0.01 * 190'000 / static_cast<double>(n);
    CHECK(generate_fractures({family}, box, 8, 7).size() > 180'000);
    family.p32 = 0.01 * 220'000 / static_cast<double>(n);
    CHECK_THROWS(generate_fractures({family}, box, 8, 7));
  }
}

TEST_CASE("a fracture is a plane polygon whose border stays, and a bent or continued surface is none", "[fractures]") {
  TriangulatedSurface square;
  square.kind = SurfaceKind::fault;
  square.points = {{0, 0, 0}, {1, 0, 0.5}, {1, 1, 0.5}, {0, 1, 0}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  TriangulatedSurface bent = square, inner = square, horizon = square;
  bent.points[2].z = 0.6;
  inner.points.push_back({0.5, 0.5, 0.25});
  inner.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  horizon.kind = SurfaceKind::horizon;
  ModelRules rules;
  rules.surfaces.resize(5);
  for (std::size_t s = 0; s < 4; ++s) rules.surfaces[s].continues = false;
  const std::vector<TriangulatedSurface> surfaces{square, bent, inner, horizon, square};
  CHECK(plane_polygons(surfaces, rules) == std::vector<bool>{true, false, false, false, false});
  CHECK_FALSE(is_fracture_network(surfaces, rules));
  CHECK(is_fracture_network({square}, rules));
  CHECK_FALSE(is_fracture_network({}, rules));
}

TEST_CASE("the crossings of a network are estimated from samples, and one that is too dense is refused",
          "[fractures]") {
  // Squares at right angles to each axis: each crosses all of the other two sets, and three of them meet in a point.
  const double n = 60, size = 100;
  std::vector<TriangulatedSurface> squares;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (double k = 1; k <= n; ++k) {
      TriangulatedSurface& s = squares.emplace_back();
      for (const auto& [u, v] : {std::pair(-1.0, -1.0), {101.0, -1.0}, {101.0, 101.0}, {-1.0, 101.0}}) {
        Vec3& p = s.points.emplace_back();
        p[axis] = k * size / (n + 1);
        p[(axis + 1) % 3] = u;
        p[(axis + 2) % 3] = v;
      }
      s.triangles = {{0, 1, 2}, {0, 2, 3}};
    }
  std::vector<const TriangulatedSurface*> rows;
  for (const TriangulatedSurface& s : squares) rows.push_back(&s);
  const NetworkCrossings found = estimate_crossings(rows, cube(size));
  CHECK(found.lines == Approx(3 * n * n));
  CHECK(found.points == Approx(n * n * n));

  RefinementSettings settings;
  settings.max_elements = 1'200'000;
  CHECK_NOTHROW(require_countable(found, rows.size(), settings));
  settings.max_elements = 1'000'000;
  CHECK_THROWS_WITH(require_countable(found, rows.size(), settings),
                    "fractures: 180 of them cross each other in about 11,000 lines and 220,000 points, which comes to "
                    "1,100,000 elements or more, beyond the limit of 1,000,000 (mesh: {max_elements}): fewer or "
                    "smaller fractures can be meshed");
}

TEST_CASE("parallel fractures, and those that cross outside of the model, have no crossings", "[fractures]") {
  std::vector<TriangulatedSurface> squares(3);
  for (std::size_t i = 0; i < 3; ++i) {
    const double z = static_cast<double>(i);
    squares[i].points = {{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}};
    squares[i].triangles = {{0, 1, 2}, {0, 2, 3}};
  }
  squares[2].points = {{2, 0, -1}, {2, 1, -1}, {0.5, 1, 2}, {0.5, 0, 2}};  // meets z = 0 at x = 1.5 and z = 1 at x = 1
  const std::vector<const TriangulatedSurface*> rows{&squares[0], &squares[1], &squares[2]};
  Box3 left;
  left.add({0, 0, -1});
  left.add({0.9, 1, 2});
  CHECK(estimate_crossings(rows, left).lines == 0);
  CHECK(estimate_crossings({}, left).lines == 0);
}
