// SPDX-License-Identifier: GPL-3.0-or-later
// Signs of the checker's own arithmetic where rounding decides nothing: a unit in the last place about what is flat, or
// on one sphere.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "check/exact/exact.hpp"

using geomesh::Sign;
using geomesh::Vec3;
using namespace geomesh::geomodel::checking;

namespace {

double next(double x, int way) { return std::nextafter(x, way * 1e9); }

}  // namespace

TEST_CASE("The checker's in-sphere test is exact to the last bit", "[check]") {
  const std::array<Vec3, 4> cell{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  // on one sphere with {0, 1}^3
  REQUIRE(orientation(cell[0], cell[1], cell[2], cell[3]) == Sign::positive);
  std::array<int, 4> order{0, 1, 2, 3};
  do {
    const auto [a, b, c, d] = std::array{cell[order[0]], cell[order[1]], cell[order[2]], cell[order[3]]};
    const bool is_positive = orientation(a, b, c, d) == Sign::positive;
    const Sign inside = is_positive ? Sign::positive : Sign::negative,
               outside = is_positive ? Sign::negative : Sign::positive;
    for (const Vec3& e : {Vec3{1, 1, 1}, Vec3{1, 1, 0}, Vec3{1, 0, 1}, Vec3{0, 1, 1}}) {
      CHECK(in_sphere(a, b, c, d, e) == Sign::zero);
      for (std::size_t i = 0; i < 3; ++i)
        for (const int way : {-1, 1}) {
          Vec3 moved = e;
          moved[i] = e[i] == 0 ? way * 1e-17 : next(e[i], way);
          CHECK(in_sphere(a, b, c, d, moved) == ((e[i] > 0.5) == (way > 0) ? outside : inside));
        }
    }
    CHECK(in_sphere(a, b, c, d, {0.5, 0.5, 0.5}) == inside);
    CHECK(in_sphere(a, b, c, d, {2, 2, 2}) == outside);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST_CASE("The checker's orientation is exact to the last bit", "[check]") {
  const Vec3 a{0.1, 0.2, 0.3}, b{1.1, 0.2, 0.3}, c{0.1, 1.2, 0.3};
  CHECK(orientation(a, b, c, {7, 9, 0.3}) == Sign::zero);
  CHECK(orientation(a, b, c, {7, 9, next(0.3, 1)}) == Sign::positive);
  CHECK(orientation(a, b, c, {7, 9, next(0.3, -1)}) == Sign::negative);
  const Vec3 u{0.1, 0.1, 0.1}, v{0.3, 0.3, 0.3}, w{0.7, 0.7, 0.7};  // a line, and so any fourth point
  CHECK(orientation(u, v, w, {5, -1, 2}) == Sign::zero);
}

TEST_CASE("The checker's orientation does not take three points in a plane along the axes for four", "[check]") {
  // a, b and c have one coordinate in common, and lie on a line but for the last bit of one number.
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int way : {-1, 0, 1}) {
      const auto place = [&](double along, double u, double v) {
        Vec3 p;
        p[axis] = along;
        p[(axis + 1) % 3] = u;
        p[(axis + 2) % 3] = v;
        return p;
      };
      const double last = way == 0 ? 0.7 : next(0.7, way);
      const Sign due = way == 0 ? Sign::zero : way > 0 ? Sign::positive : Sign::negative;
      CHECK(orientation(place(1, 0.1, 0.1), place(1, 0.3, 0.3), place(1, 0.7, last), place(2, 5, 5)) == due);
    }
}
