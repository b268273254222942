// SPDX-License-Identifier: GPL-3.0-or-later
// Convex parts of plane patches, and roofs over them.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "geomesh/core/predicates.hpp"
#include "plc/convex_parts.hpp"
#include "plc/roof.hpp"

using namespace geomesh;

namespace {

/// On an ellipse in the plane z = x - 3 y, on a grid of 2^-20.
std::vector<Vec3> ellipse(unsigned n) {
  std::vector<Vec3> out;
  for (unsigned i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979 * i / n;
    const double x = std::ldexp(std::round(std::ldexp(2 * std::cos(angle), 20)), -20),
                 y = std::ldexp(std::round(std::ldexp(std::sin(angle), 20)), -20);
    out.push_back({x, y, x - 3 * y});
  }
  return out;
}

std::vector<ConvexPart> parts_of(const std::vector<Vec3>& points, std::vector<Triangle> triangles,
                                 const std::vector<FlatPatch::Edge>& segments = {}) {
  const auto patch = FlatPatch::of(points, std::move(triangles));
  REQUIRE(patch);
  return convex_parts(*patch, segments);
}

}  // namespace

TEST_CASE("a roof has no triangle on the border alone, and its points lie in the plane", "[plc]") {
  for (const unsigned n : {8u, 100u, 1000u}) {
    const std::vector<Vec3> corners = ellipse(n);
    const auto roof = roof_over(corners, [](const auto&) { return std::size_t{2}; });
    REQUIRE(roof);
    CHECK(roof->inner.size() <= 12);
    CHECK(roof->triangles.size() == n + 2 * roof->inner.size() - 2);
    for (const Triangle& t : roof->triangles) CHECK((t[0] >= n || t[1] >= n || t[2] >= n));
    for (const Vec3& p : roof->inner) CHECK(p.z == p.x - 3 * p.y);
    for (const double rise : roof->rise) CHECK(rise > 0);
  }
}

TEST_CASE("polygons that are stacked along the axis get points above each other", "[plc]") {
  const auto along_z = [](const auto&) { return std::size_t{2}; };
  std::vector<Vec3> corners = ellipse(101);
  const auto lower = roof_over(corners, along_z);
  std::rotate(corners.begin(), corners.begin() + 40, corners.end());
  std::reverse(corners.begin(), corners.end());
  for (Vec3& p : corners) p.z += 0.375;
  const auto upper = roof_over(corners, along_z);
  REQUIRE(lower);
  REQUIRE(upper);
  REQUIRE(lower->inner.size() == upper->inner.size());
  for (std::size_t i = 0; i < lower->inner.size(); ++i) CHECK(upper->inner[i] == lower->inner[i] + Vec3{0, 0, 0.375});
}

TEST_CASE("a patch falls into convex parts, which segments separate", "[plc]") {
  const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<Triangle> halves{{0, 1, 2}, {0, 2, 3}};
  CHECK(parts_of(square, halves).size() == 1);
  CHECK(parts_of(square, halves).front().border.size() == 4);
  CHECK(parts_of(square, halves).front().left_out.size() == 1);
  CHECK(parts_of(square, halves, {{2, 0}}).size() == 2);
  const std::vector<Vec3> notched{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 1, 0}, {0, 2, 0}};
  CHECK(parts_of(notched, {{0, 1, 3}, {1, 2, 3}, {0, 3, 4}}).size() == 2);
}
