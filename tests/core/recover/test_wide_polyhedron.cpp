// SPDX-License-Identifier: GPL-3.0-or-later
// Doubles in polyhedra that are thinner than the spacing of doubles.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "predicates/long_expansion.hpp"
#include "recover/rounding/wide_polyhedron.hpp"

using namespace geomesh;
using namespace geomesh::recover;
using exact::LongExpansion;
using exact::TwoDouble;

namespace {

constexpr Vec3 corner{432117.25, 6512408.5, -1533.75};

/// |normal . (y - middle)| < width, for each of three normals; y is relative to a corner at coordinates of a map grid.
struct Slab {
  std::array<Vec3, 3> normals;
  std::array<double, 3> widths;
  Vec3 middle{};

  WidePolyhedron polyhedron() const {
    WidePolyhedron out;
    out.origin = corner;
    for (std::size_t i = 0; i < 3; ++i) out.spacing[i] = std::ldexp(1.0, std::ilogb(corner[i]) - 52);
    for (std::size_t k = 0; k < 3; ++k)
      for (const double sign : {1.0, -1.0}) {
        WidePlane plane{{}, {widths[k]}};
        for (std::size_t i = 0; i < 3; ++i) {
          plane.normal[i] = TwoDouble{sign * normals[k][i]};
          plane.at = plane.at - plane.normal[i] * TwoDouble{middle[i]};
        }
        out.planes.push_back(plane);
      }
    for (std::size_t i = 0; i < 3; ++i) out.inside[i] = TwoDouble{middle[i]};
    return out;
  }
  bool holds(const Vec3& p) const {
    for (std::size_t k = 0; k < 3; ++k) {
      LongExpansion along;
      for (std::size_t i = 0; i < 3; ++i)
        along = along + (LongExpansion(p[i]) - LongExpansion(corner[i]) - LongExpansion(middle[i])) *
                            LongExpansion(normals[k][i]);
      for (const double sign : {1.0, -1.0})
        if ((LongExpansion(widths[k]) + along * sign).sign() != Sign::positive) return false;
    }
    return true;
  }
  bool is_found() const {
    return find_double_inside(polyhedron(), [this](const Vec3& p) { return holds(p); });
  }
};

std::array<Vec3, 3> random_frame(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto unit = [](const Vec3& v) { return (1 / std::sqrt(dot(v, v))) * v; };
  const Vec3 a = unit({normal(random), normal(random), normal(random)});
  const Vec3 b = unit(cross(a, {normal(random), normal(random), normal(random)}));
  return {a, b, cross(a, b)};
}

}  // namespace

TEST_CASE("a slab of a thousandth of an ulp holds doubles, and so does a needle", "[recover]") {
  std::mt19937 random(7);
  for (unsigned seed = 0; seed < 200; ++seed) {
    const std::array<Vec3, 3> frame = random_frame(random);
    INFO(seed);
    CHECK(Slab{frame, {1e-13, 100, 10}}.is_found());
    CHECK(Slab{frame, {1e-15, 1, 100}}.is_found());
    CHECK(Slab{frame, {1e-10, 1e-10, 1000}}.is_found());
    CHECK(Slab{frame, {1, 1, 1}}.is_found());
  }
}

TEST_CASE("a slab far longer than thick holds doubles, also where its middle is far from the corner", "[recover]") {
  std::mt19937 random(11);
  for (unsigned seed = 0; seed < 200; ++seed) {
    const std::array<Vec3, 3> frame = random_frame(random);
    const Vec3 middle = 200 * frame[1] + 30 * frame[2];
    INFO(seed);
    CHECK(Slab{frame, {1e-15, 250, 40}, middle}.is_found());
    CHECK(Slab{frame, {1e-16, 250, 250}, middle}.is_found());
    CHECK(Slab{frame, {1e-13, 1e-8, 250}, 200 * frame[2]}.is_found());
  }
}

TEST_CASE("a slab along the lattice of doubles, between two of its layers, holds none", "[recover]") {
  const double ulp = std::ldexp(1.0, std::ilogb(corner.x) - 52);
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  WidePolyhedron between = Slab{{x, y, z}, {0.25 * ulp, 10, 10}}.polyhedron();
  for (unsigned k : {0u, 1u}) between.planes[k].at = {(k == 0 ? -0.25 : 0.75) * ulp};
  between.inside[0] = TwoDouble{0.5 * ulp};
  CHECK(!find_double_inside(between, [&](const Vec3& p) { return p.x > corner.x && p.x < corner.x + ulp; }));
  CHECK(Slab{{x, y, z}, {0.25 * ulp, 10, 10}}.is_found());  // about a layer
}

TEST_CASE("the first point found lies well inside where there is room", "[recover]") {
  const Slab ball{{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}, {8, 8, 8}};
  Vec3 first;
  CHECK(find_double_inside(ball.polyhedron(), [&](const Vec3& p) {
    first = p;
    return true;
  }));
  CHECK(std::sqrt(dot(first - corner, first - corner)) < 1);
}
