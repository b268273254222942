// SPDX-License-Identifier: GPL-3.0-or-later
// Predicates against rationals: sign tables, near-degenerate sweeps, scalings by powers of two and of ten, random
// degenerate grids.
#include <CGAL/Gmpq.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "geomesh/core/predicates.hpp"

using namespace geomesh;

namespace {

using Rational = CGAL::Gmpq;
using Row = std::vector<Rational>;

Sign sign_of(const Rational& x) { return x > 0 ? Sign::positive : x < 0 ? Sign::negative : Sign::zero; }

/// Determinant by expansion along the first row; independent of the code under test.
Rational determinant(const std::vector<Row>& m) {
  if (m.size() == 1) return m[0][0];
  Rational sum = 0;
  for (std::size_t k = 0; k < m.size(); ++k) {
    std::vector<Row> rest;
    for (std::size_t i = 1; i < m.size(); ++i) {
      Row row;
      for (std::size_t j = 0; j < m.size(); ++j)
        if (j != k) row.push_back(m[i][j]);
      rest.push_back(row);
    }
    const Rational term = m[0][k] * determinant(rest);
    sum = k % 2 == 0 ? Rational(sum + term) : Rational(sum - term);
  }
  return sum;
}

Row row(const Vec3& p, const Vec3& origin, bool lifted) {
  Row r{Rational(p.x) - Rational(origin.x), Rational(p.y) - Rational(origin.y), Rational(p.z) - Rational(origin.z)};
  if (lifted) r.push_back(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
  return r;
}
Row row(const Vec2& p, const Vec2& origin, bool lifted) {
  Row r{Rational(p.x) - Rational(origin.x), Rational(p.y) - Rational(origin.y)};
  if (lifted) r.push_back(r[0] * r[0] + r[1] * r[1]);
  return r;
}

Sign rational_orient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
  return sign_of(determinant({row(b, a, false), row(c, a, false)}));
}
Sign rational_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return sign_of(determinant({row(b, a, false), row(c, a, false), row(d, a, false)}));
}
Sign rational_in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return sign_of(determinant({row(a, d, true), row(b, d, true), row(c, d, true)}));
}
Sign rational_in_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  return -sign_of(determinant({row(a, e, true), row(b, e, true), row(c, e, true), row(d, e, true)}));
}

Vec3 scaled(const Vec3& p, double s) { return {s * p.x, s * p.y, s * p.z}; }

struct Random {
  std::mt19937_64 engine{20240601};
  double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
  double integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine); }
  Vec3 point(double size) { return {real(-size, size), real(-size, size), real(-size, size)}; }
  Vec3 grid_point(int n) { return {integer(0, n), integer(0, n), integer(0, n)}; }
};

void compare_all(const std::array<Vec3, 5>& p) {
  const Vec2 a{p[0].x, p[0].y}, b{p[1].x, p[1].y}, c{p[2].x, p[2].y}, d{p[3].x, p[3].y};
  CHECK(orient2d(a, b, c) == rational_orient2d(a, b, c));
  CHECK(orient3d(p[0], p[1], p[2], p[3]) == rational_orient3d(p[0], p[1], p[2], p[3]));
  CHECK(in_circle(a, b, c, d) == rational_in_circle(a, b, c, d));
  CHECK(in_sphere(p[0], p[1], p[2], p[3], p[4]) == rational_in_sphere(p[0], p[1], p[2], p[3], p[4]));
}

}  // namespace

TEST_CASE("predicates: sign tables", "[predicates]") {
  const Vec3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  CHECK(orient2d({0, 0}, {1, 0}, {0, 1}) == Sign::positive);
  CHECK(orient2d({0, 0}, {0, 1}, {1, 0}) == Sign::negative);
  CHECK(orient2d({0, 0}, {1, 1}, {2, 2}) == Sign::zero);
  CHECK(orient3d(o, x, y, z) == Sign::positive);
  CHECK(orient3d(o, y, x, z) == Sign::negative);
  CHECK(orient3d(o, x, y, {5, 7, 0}) == Sign::zero);
  CHECK(in_circle({0, 0}, {1, 0}, {0, 1}, {0.5, 0.5}) == Sign::positive);
  CHECK(in_circle({0, 0}, {1, 0}, {0, 1}, {1, 1}) == Sign::zero);
  CHECK(in_circle({0, 0}, {1, 0}, {0, 1}, {2, 2}) == Sign::negative);
  CHECK(in_sphere(o, x, y, z, {0.5, 0.5, 0.5}) == Sign::positive);
  CHECK(in_sphere(o, x, y, z, {1, 1, 1}) == Sign::zero);
  CHECK(in_sphere(o, x, y, z, {2, 2, 2}) == Sign::negative);
  CHECK(collinear(o, {1, 2, 3}, {2, 4, 6}));
  CHECK_FALSE(collinear(o, {1, 2, 3}, {2, 4, 6.0000000000000009}));
  CHECK(compare_lexicographic({0, 1, 2}, {0, 1, 3}) == -1);
  CHECK(compare_lexicographic({-0.0, 1, 2}, {0.0, 1, 2}) == 0);
}

TEST_CASE("predicates: near-degenerate sweeps agree with rationals", "[predicates]") {
  const double ulp = std::numeric_limits<double>::epsilon();
  for (int i = -8; i <= 8; ++i)
    for (int j = -8; j <= 8; ++j) {
      const Vec2 p{0.5 + i * ulp, 0.5 + j * ulp};
      CHECK(orient2d(p, {12, 12}, {24, 24}) == rational_orient2d(p, {12, 12}, {24, 24}));
      const Vec3 q{0.5 + i * ulp, 0.5 + j * ulp, 0.5 + (i - j) * ulp};
      compare_all({q, {12, 12, 12}, {24, 24, 23}, {48, 48, 47}, {1, 2, 3}});
      // Cospherical up to ulps: corners of a cube shifted by a number that is not a binary fraction.
      const Vec3 s{0.1, 0.2, 0.3};
      compare_all({s, s + Vec3{1, 0, 0}, s + Vec3{0, 1, 0}, s + Vec3{0, 0, 1}, s + Vec3{1 + i * ulp, 1 + j * ulp, 1}});
    }
}

TEST_CASE("predicates: random and degenerate tuples under scalings", "[predicates]") {
  Random random;
  for (int k = 0; k < 300; ++k) {
    std::array<Vec3, 5> p;
    for (Vec3& q : p) q = k % 3 == 0 ? random.point(1) : random.grid_point(k % 3 == 1 ? 2 : 4);
    if (k % 5 == 0) p[4] = 0.25 * (p[0] + p[1] + p[2] + p[3]);
    compare_all(p);
    const int power = static_cast<int>(random.integer(-40, 40)), decimal = static_cast<int>(random.integer(-20, 20));
    std::array<Vec3, 5> by_two, by_ten, shifted;
    for (std::size_t i = 0; i < 5; ++i) {
      by_two[i] = scaled(p[i], std::ldexp(1.0, 3 * power));
      by_ten[i] = scaled(p[i], std::pow(10.0, 2 * decimal));
      shifted[i] = scaled(p[i], 0.1) + Vec3{549500.3, 7820100.7, -9000.9};
    }
    CHECK(in_sphere(p[0], p[1], p[2], p[3], p[4]) == in_sphere(by_two[0], by_two[1], by_two[2], by_two[3], by_two[4]));
    compare_all(by_two);
    compare_all(by_ten);
    compare_all(shifted);
  }
}

TEST_CASE("predicates: one tuple whose coordinates span many orders of magnitude", "[predicates]") {
  Random random;
  for (int k = 0; k < 200; ++k) {
    std::array<Vec3, 5> p;
    for (Vec3& q : p) q = scaled(random.point(1), std::pow(10.0, random.integer(-12, 6)));
    compare_all(p);
    for (Vec3& q : p) q.z = 1e-9 * q.z;
    compare_all(p);
  }
}

TEST_CASE("predicates: limits of the exponents are held and stated", "[predicates]") {
  const std::vector<double> good{0.0, -0.0, 0x1p-148, -0x1p-148, 0x1.fffffffffffffp147};
  for (double x : good) CHECK(exponents_are_safe(std::vector<Vec3>{{x, 1, 1}, {1, 1, x}}));
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for (double x : {0x1p-149, 1e-300, 5e-324, 0x1p148, -1e300, inf, -inf, nan})
    CHECK_FALSE(exponents_are_safe(std::vector<Vec3>{{1, x, 1}}));
  Random random;
  for (double s : {0x1p147, 0x1p-147})
    for (int k = 0; k < 20; ++k) {
      std::array<Vec3, 5> p;
      for (Vec3& q : p) q = scaled({random.real(1, 2), random.real(1, 2), random.real(1, 2)}, 0.5 * s);
      if (s < 1)
        for (Vec3& q : p) q = scaled(q, 2);
      p[4] = 0.5 * (p[0] + p[3]);
      REQUIRE(exponents_are_safe(p));
      compare_all(p);
    }
}

TEST_CASE("predicates: the perturbation never ties, does not see the numbering, and is one for all dimensions",
          "[predicates]") {
  Random random;
  int spheres = 0, circles = 0;
  while (spheres < 400) {
    std::array<Vec3, 5> p;
    for (Vec3& q : p) q = random.grid_point(2);
    const Sign o = orient3d(p[0], p[1], p[2], p[3]);
    bool distinct = o != Sign::zero;
    for (std::size_t i = 0; i < 4; ++i) distinct = distinct && !(p[i] == p[4]);
    if (!distinct) continue;
    ++spheres;
    if (o == Sign::negative) std::swap(p[0], p[1]);
    const Sign s = in_sphere_perturbed(p[0], p[1], p[2], p[3], p[4]);
    CHECK(s != Sign::zero);
    CHECK(s == in_sphere_perturbed(p[1], p[2], p[0], p[3], p[4]));
    CHECK(s == in_sphere_perturbed(p[1], p[0], p[3], p[2], p[4]));
    CHECK(s == in_sphere_perturbed(p[3], p[2], p[1], p[0], p[4]));
  }
  while (circles < 400) {
    std::array<Vec2, 4> p;
    for (Vec2& q : p) q = {random.integer(0, 3), random.integer(0, 3)};
    if (orient2d(p[0], p[1], p[2]) != Sign::positive || p[3] == p[0] || p[3] == p[1] || p[3] == p[2]) continue;
    ++circles;
    const Sign s = in_circle_perturbed(p[0], p[1], p[2], p[3]);
    CHECK(s != Sign::zero);
    CHECK(s == in_circle_perturbed(p[1], p[2], p[0], p[3]));
    auto lift = [](const Vec2& q) { return Vec3{q.x, q.y, 7.25}; };
    CHECK(s == in_circle_coplanar_perturbed(lift(p[0]), lift(p[1]), lift(p[2]), lift(p[3])));
    CHECK(s == in_circle_coplanar_perturbed(lift(p[1]), lift(p[0]), lift(p[2]), lift(p[3])));
    // A slanted plane that keeps lexicographic order; a shear, so compare with the sphere through an apex far off the
    // plane.
    auto slant = [](const Vec2& q) { return Vec3{q.x, q.y, q.x + 2 * q.y}; };
    const Sign c = in_circle_coplanar_perturbed(slant(p[0]), slant(p[1]), slant(p[2]), slant(p[3]));
    const Vec3 apex{-100, 3, 900};  // lexicographically least: its own height decides nothing
    CHECK(c == in_sphere_perturbed(slant(p[0]), slant(p[1]), slant(p[2]), apex, slant(p[3])));
  }
}
