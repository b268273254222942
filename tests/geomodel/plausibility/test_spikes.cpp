// SPDX-License-Identifier: GPL-3.0-or-later
// Single vertices far above or below all neighbours, and what is none of them.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <random>

#include "plausibility/spikes.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

/// A grid of n by n nodes 100 m apart.
TriangulatedSurface grid(VertexIndex n, const std::function<double(int, int)>& height) {
  TriangulatedSurface s;
  s.name = "top";
  for (VertexIndex j = 0; j < n; ++j)
    for (VertexIndex i = 0; i < n; ++i)
      s.points.push_back({100.0 * i, 100.0 * j, height(static_cast<int>(i), static_cast<int>(j))});
  for (VertexIndex j = 0; j + 1 < n; ++j)
    for (VertexIndex i = 0; i + 1 < n; ++i) {
      const VertexIndex a = j * n + i;
      s.triangles.push_back({a, a + 1, a + n + 1});
      s.triangles.push_back({a, a + n + 1, a + n});
    }
  return s;
}

double smooth(int i, int j) { return -1500 + 40 * std::sin(0.2 * i) + 3.0 * j; }

}  // namespace

TEST_CASE("a slip of digits in one node is found, above and below, with its place and the steps beside it",
          "[spikes]") {
  for (const double sign : {1.0, -1.0}) {
    const Spikes found = find_spikes(grid(20, [&](int i, int j) {
      return sign * (i == 7 && j == 11 ? smooth(i, j) + 300 : smooth(i, j) - (i == 15 && j == 3 ? 200 : 0));
    }));
    CHECK(found.n == 2);
    CHECK(found.place == Vec3{700, 1100, sign * (smooth(7, 11) + 300)});
    CHECK(found.height * sign > 280);
    CHECK(found.height * sign < 300);
    CHECK(found.around < 30);
  }
}

TEST_CASE("noise, mountains, steps, smeared throw and summits of coarse surfaces are no spikes", "[spikes]") {
  std::mt19937 dice(5);
  std::normal_distribution<double> noise(0, 20);
  CHECK(find_spikes(grid(60, [&](int, int) { return noise(dice); })).n == 0);
  CHECK(find_spikes(grid(60,
                         [&](int i, int j) {  // mountains in a plain
                           return i > 30 ? std::abs(600 * std::sin(0.9 * i) * std::cos(0.7 * j)) + noise(dice)
                                         : 0.01 * j;
                         }))
            .n == 0);
  CHECK(find_spikes(grid(30, [](int i, int j) { return smooth(i, j) - (i > 14 ? 300 : 0); })).n == 0);
  CHECK(find_spikes(grid(30, [](int i, int j) { return smooth(i, j) - (i > 15 ? 300 : i == 15 ? 150 : 0); })).n == 0);
  CHECK(find_spikes(grid(3, [](int i, int j) { return i == 1 && j == 1 ? 500.0 : 0.0; })).n == 0);
  CHECK(find_spikes({}).n == 0);
}
