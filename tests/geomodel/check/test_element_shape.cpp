// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes as the checker measures them, beside those of the mesher: apart by what rounding explains, and by no more.
#include <catch2/catch.hpp>
#include <cmath>

#include "check/arrays/element_shape.hpp"
#include "dice.hpp"
#include "geomesh/core/quality.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::checking;
using geomesh::geomodel::testing::Dice;

namespace {

constexpr double ulp = 9.313225746154785e-10;  // of 4,194,304 to 8,388,608

/// A tetrahedron of about 1,000 m at map coordinates. Its fourth corner is off the plane of the others by `height`, its
/// second one off the first by `edge`.
std::array<Vec3, 4> tetrahedron(Dice& dice, double edge, double height) {
  const Vec3 a{dice.between(5e6, 5.1e6), dice.between(4e5, 5e5), dice.between(-2000, 0)};
  const auto step = [&] { return Vec3{dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1)}; };
  const Vec3 u = step(), v = step();
  const Vec3 normal = (1 / std::sqrt(dot(cross(u, v), cross(u, v)))) * cross(u, v);
  const Vec3 d = a + 300.0 * u + 400.0 * v + height * normal;
  return {a, a + edge * u, a + 1000.0 * v, d};
}

void agree(const std::array<Vec3, 4>& p) {
  const TetrahedronShape told = tetrahedron_shape(p[0], p[1], p[2], p[3]);
  const ElementShape due = element_shape(p, ulp);
  const auto is_near = [](double a, double b, double slack) { CHECK(std::abs(a - b) <= slack); };
  is_near(told.min_dihedral, due.min_dihedral, due.slack_of_angles());
  is_near(told.max_dihedral, due.max_dihedral, due.slack_of_angles());
  is_near(told.radius_ratio, due.radius_ratio, due.slack_of_ratios());
  is_near(told.mean_ratio, due.mean_ratio, due.slack_of_ratios());
  is_near(told.aspect, due.aspect, due.slack_of_ratios());
  is_near(told.shortest_edge, due.shortest_edge, due.slack_of_lengths());
  is_near(told.longest_edge, due.longest_edge, due.slack_of_lengths());
}

}  // namespace

TEST_CASE("The checker's shapes of common elements are told to a millionth", "[check]") {
  Dice dice(1);
  for (int k = 0; k < 2000; ++k) {
    const auto p = tetrahedron(dice, 1000, dice.between(200, 1000));
    const ElementShape shape = element_shape(p, ulp);
    CHECK(shape.slack_of_angles() < 1e-5);
    CHECK(shape.slack_of_ratios() < 1e-6);
    agree(p);
  }
}

TEST_CASE("The checker's shapes of slivers and needles are as uncertain as rounding makes them", "[check]") {
  Dice dice(2);
  for (const double edge : {1000.0, 1.0, 1e-3, 1e-6, 1e-9})
    for (const double height : {1000.0, 1.0, 1e-3, 1e-6, 1e-9})
      for (int k = 0; k < 200; ++k) {
        INFO("edge " << edge << ", height " << height);
        agree(tetrahedron(dice, edge, height));
      }
}

TEST_CASE("The checker's shape of the regular tetrahedron", "[check]") {
  const ElementShape s = element_shape({Vec3{0, 0, 0}, Vec3{1, 1, 0}, Vec3{1, 0, 1}, Vec3{0, 1, 1}}, 2.2e-16);
  for (const double angle : s.dihedral) CHECK(angle == Approx(70.528779365509308));
  CHECK(s.radius_ratio == Approx(1));
  CHECK(s.mean_ratio == Approx(1));
  CHECK(s.aspect == Approx(1));
  CHECK(s.shortest_edge == Approx(std::sqrt(2.0)));
}
