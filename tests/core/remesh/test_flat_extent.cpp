// SPDX-License-Identifier: MIT
// Over which lengths a surface is flat but for a tolerance.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <random>

#include "remesh/sizes/flat_extent.hpp"

using namespace geomesh;
using remesh::FlatExtent;

namespace {

/// A square of 10 x 10 in n x n cells of two triangles.
FlatExtent graph(unsigned n, const std::function<double(double, double)>& height) {
  std::vector<FlatExtent::Face> faces;
  const auto at = [&](unsigned i, unsigned j) {
    const double x = 10.0 * i / n, y = 10.0 * j / n;
    return Vec3{x, y, height(x, y)};
  };
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = 0; j < n; ++j) {
      const Vec3 a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      faces.push_back({{a, b, c}, 0});
      faces.push_back({{a, c, d}, 0});
    }
  return {std::move(faces), 4};
}

}  // namespace

TEST_CASE("an inclined plane is flat over the greatest length that is looked at", "[sizes]") {
  FlatExtent extent = graph(40, [](double x, double y) { return 3 * x - 0.7 * y; });
  CHECK(extent.at(0, {5, 5, 11.5}, 0.1, 1e-6) == 4);
}

TEST_CASE("noise below the tolerance leaves a surface flat, though it turns at every edge", "[sizes]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-0.03, 0.03);
  FlatExtent extent = graph(80, [&](double x, double) { return 0.2 * x + noise(random); });
  CHECK(extent.at(0, {5, 5, 1}, 0.1, 0.1) == 4);
  CHECK(extent.at(0, {5, 5, 1}, 0.1, 0.02) == 0);
}

TEST_CASE("a surface of even curvature is flat over about the length whose chords keep the tolerance", "[sizes]") {
  for (const double radius : {5.0, 20.0, 80.0}) {
    FlatExtent extent = graph(160, [&](double x, double) { return 0.5 * (x - 5) * (x - 5) / radius; });
    const double tolerance = 0.02, chord = std::sqrt(8 * radius * tolerance);
    const double found = extent.at(0, {5, 5, 0}, 0.1, tolerance);
    INFO(radius);
    CHECK(found > 0.4 * chord);
    CHECK(found <= chord);
  }
}

TEST_CASE("waves higher than the tolerance are seen however even their mean direction is", "[sizes]") {
  FlatExtent extent = graph(160, [](double x, double) { return 0.2 * std::sin(2 * 3.14159 * x); });
  CHECK(extent.at(0, {5, 5, 0}, 0.05, 0.1) < 0.6);
  CHECK(extent.at(0, {5, 5, 0}, 0.05, 1.0) == 4);
}

TEST_CASE("another patch beside does not count", "[sizes]") {
  std::vector<FlatExtent::Face> faces{{{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}, 0},
                                      {{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}}, 1}};
  FlatExtent extent(faces, 4);
  CHECK(extent.at(0, {0.3, 0.3, 0}, 0.1, 1e-6) == 4);
}
