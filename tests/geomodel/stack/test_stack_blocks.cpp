// SPDX-License-Identifier: GPL-3.0-or-later
// Horizons that stop short of a fault with throw, settled block by block.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <set>

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/planar/map_locator.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

constexpr double width = 10000, throw_of_fault = 150;

/// The fault stands at x = 5000. Both horizons stop 100 m before it, and touch and cross by noise from y = 5000 on.
double height(int horizon, double x, double y) {
  const double z = 60 * std::sin(x / 1500) - (x > 5000 ? throw_of_fault : 0);
  return horizon == 0 ? z : z - std::max(0.0, 0.1 * (5000 - y));
}

TriangulatedSurface grid(const std::string& name, int horizon) {
  std::mt19937 random(static_cast<unsigned>(horizon));
  std::uniform_real_distribution<double> noise(-3, 3);
  TriangulatedSurface s;
  s.name = name;
  s.kind = SurfaceKind::horizon;
  constexpr int n = 111;
  const auto at = [](int i) { return -500 + 100.0 * i; };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) s.points.push_back({at(i), at(j), height(horizon, at(i), at(j)) + noise(random)});
  for (int j = 0; j + 1 < n; ++j)
    for (int i = 0; i + 1 < n; ++i) {
      if (at(i) > 4850 && at(i) < 5050) continue;
      const auto a = static_cast<VertexIndex>(j * n + i), c = a + static_cast<VertexIndex>(n);
      s.triangles.push_back({a, a + 1, c + 1});
      s.triangles.push_back({a, c + 1, c});
    }
  return s;
}

TriangulatedSurface fault() {
  TriangulatedSurface s;
  s.name = "fault";
  s.kind = SurfaceKind::fault;
  s.points = {{5000, -100, -3100}, {5000, width + 100, -3100}, {5000, width + 100, 1100}, {5000, -100, 1100}};
  s.triangles = {{0, 1, 2}, {0, 2, 3}};
  return s;
}

ModelRules rules_of(double within) {
  ModelRules rules;
  rules.column = {"air", "top", "sand", "base", "shale"};
  rules.box = Box3{{0, 0, -3000}, {width, width, 1000}};
  rules.stack.size = 500;
  rules.stack.tolerance = 20;
  rules.stack.outline = {{0, 0}, {width, 0}, {width, width}, {0, width}};
  rules.stack.outline_is_box = true;
  rules.continuation.within_of_horizons = rules.continuation.within_of_faults = within;
  rules.continuation.bounds = *rules.box;
  rules.continuation.sides = {TriangulatedSurface{}};  // a box: its bounds tell all
  return rules;
}

/// What was given, or lies in its block as if it was.
TriangulatedSurface inside(const BuiltSurfaces& built, Index row) {
  TriangulatedSurface s = built.surfaces[row];
  s.triangles.resize(built.rows.n_given_triangles[row]);
  return s;
}

}  // namespace

TEST_CASE("a stack whose horizons stop short of a fault is settled on both sides of it", "[stack]") {
  const std::vector<TriangulatedSurface> given{grid("top", 0), grid("base", 1), fault()};
  const BuiltSurfaces built = build_surfaces(given, rules_of(500));
  REQUIRE(built.stack.settled);
  REQUIRE(built.stack.horizons.size() == 2);
  // Triangles along the fault are told whole where their middle lies in the block.
  CHECK(built.stack.units[0].area + built.stack.units[0].area_merged == Approx(width * width).epsilon(0.04));
  CHECK(built.stack.units[0].volume == Approx(250 * width * 5000).epsilon(0.04));
  for (Index row = 0; row < 2; ++row) {
    CHECK(built.surfaces[row].triangles.size() < given[row].triangles.size() / 4);
    const std::vector<Index>& part = built.rows.part_of_triangle[row];
    CHECK(std::is_sorted(part.begin(), part.end()));
    CHECK(std::set<Index>(part.begin(), part.end()).size() >= 3);  // inside, and beyond the fault from either side
    CHECK(built.rows.continued_to[row] == std::vector<Index>{2});
  }
  const TriangulatedSurface top = inside(built, 0), base = inside(built, 1);
  const MapLocator above(top), below(base);
  for (double x = 250; x < width; x += 500)
    for (double y = 250; y < width; y += 500) {
      const auto z0 = above.height({x, y}), z1 = below.height({x, y});
      if (std::abs(x - 5000) > 1200) REQUIRE(z0.has_value());
      if (!z0 || !z1) continue;
      CHECK(*z0 >= *z1);
      CHECK(std::abs(*z0 - height(0, x, y)) < 20);
    }
}

TEST_CASE("a stack whose horizons end in the open before a fault is left as given, and a note tells", "[stack]") {
  const std::vector<TriangulatedSurface> given{grid("top", 0), grid("base", 1), fault()};
  const BuiltSurfaces built = build_surfaces(given, rules_of(0));
  CHECK(!built.stack.settled);
  REQUIRE(built.notes.size() == 1);
  CHECK(built.notes[0].find("ends inside the model") != std::string::npos);
}
