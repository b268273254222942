// SPDX-License-Identifier: GPL-3.0-or-later
// Nearest points of segments by dense samples, and of groups of items by looking at all of them.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "common/geometry.hpp"
#include "search/closest_point.hpp"

using namespace geomesh;
using namespace geomesh::search;

namespace {

/// Steps of the grid [0, 4] in each axis, so that lines are parallel, cross and meet often.
Vec3 on_grid(std::mt19937_64& random) { return {double(random() % 5), double(random() % 5), double(random() % 5)}; }

}  // namespace

TEST_CASE("Nearest points of two segments are on them, and no samples are nearer", "[search]") {
  std::mt19937_64 random(3);
  constexpr int n_steps = 24;
  for (int round = 0; round < 400; ++round) {
    const Vec3 a = on_grid(random), b = on_grid(random), c = on_grid(random), d = on_grid(random);
    const auto [p, q] = closest_on_segments(a, b, c, d);
    const double found = squared_distance(p, q);
    double sampled = found;
    for (int i = 0; i <= n_steps; ++i)
      for (int j = 0; j <= n_steps; ++j)
        sampled = std::min(sampled,
                           squared_distance(a + (double(i) / n_steps) * (b - a), c + (double(j) / n_steps) * (d - c)));
    INFO("a = " << a.x << ' ' << a.y << ' ' << a.z << ", round " << round);
    CHECK(found <= sampled + 1e-12);
    CHECK(squared_distance(closest_on_segment(p, a, b), p) < 1e-24);
    CHECK(squared_distance(closest_on_segment(q, c, d), q) < 1e-24);
  }
}

TEST_CASE("The nearest item is of the group that is asked, whatever lies nearer in others", "[search]") {
  std::mt19937_64 random(4);
  constexpr std::size_t n_groups = 9;
  std::vector<ClosestPointTrees::Item> items;
  for (Index id = 0; id < 60; ++id)
    items.push_back({{on_grid(random), on_grid(random), on_grid(random)}, Index(random() % n_groups), id});
  const ClosestPointTrees trees(items, n_groups);
  for (int round = 0; round < 200; ++round) {
    const Vec3 p = on_grid(random) + Vec3{0.25, 0.125, 0.5};
    for (Index group = 0; group < n_groups; ++group) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const auto& item : items)
        if (item.group == group)
          nearest = std::min(nearest, squared_distance(p, PreparedTriangle(item.corners).closest_to(p)));
      const ClosestPoint found = trees.closest(p, group);
      CHECK(found.distance == std::sqrt(nearest));
      REQUIRE(found.item < items.size());
      CHECK(items[found.item].group == group);
      if (nearest > 0) CHECK_FALSE(trees.closest(p, group, 0.5 * found.distance).item < items.size());
    }
  }
}

// Needles 500 m long and a nanometre to a metre wide. The point is put off the needle along its normal, above a place
// inside, so that the distance is known.
TEST_CASE("The nearest point of a needle is right to rounding, however thin it is", "[search]") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit_interval(0, 1);
  constexpr double length = 500, rounding = 4e-12;
  for (int round = 0; round < 2000; ++round) {
    const auto draw = [&] { return unit_interval(random); };
    const Vec3 along = unit(Vec3{draw() - 0.5, draw() - 0.5, draw() - 0.5});
    const Vec3 across = unit(cross(along, Vec3{draw(), draw(), draw()})), normal = cross(along, across);
    const double width = std::pow(10, -9 + 9 * draw());
    const Vec3 a{1000 * draw(), 1000 * draw(), 1000 * draw()};
    std::array<Vec3, 3> corners{a, a + length * along, a + (length * draw()) * along + width * across};
    std::rotate(corners.begin(), corners.begin() + round % 3, corners.end());
    double u = draw(), v = draw();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Vec3 inside = corners[0] + u * (corners[1] - corners[0]) + v * (corners[2] - corners[0]);
    // A needle turns by up to the rounding of its corners over its width.
    const double off = round % 2 == 0 ? 0 : std::min(1.0, width), found = [&] {
      const Vec3 p = inside + off * normal;
      return std::sqrt(squared_distance(p, closest_on_triangle(p, corners[0], corners[1], corners[2])));
    }();
    INFO("round " << round << ", " << width << " m wide, " << off << " m off");
    CHECK(std::abs(found - off) < rounding);
  }
}
