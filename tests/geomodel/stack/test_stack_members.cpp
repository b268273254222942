// SPDX-License-Identifier: GPL-3.0-or-later
// Which horizons are settled together.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <random>

#include "stack/stack_members.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

constexpr double width = 10000;

using Height = std::function<double(double, double)>;

TriangulatedSurface grid(const std::string& name, const Height& height) {
  constexpr VertexIndex n = 61;
  TriangulatedSurface s;
  s.name = name;
  s.kind = SurfaceKind::horizon;
  for (VertexIndex j = 0; j < n; ++j)
    for (VertexIndex i = 0; i < n; ++i) {
      const double x = width * i / (n - 1), y = width * j / (n - 1);
      s.points.push_back({x, y, height(x, y)});
    }
  for (VertexIndex j = 0; j + 1 < n; ++j)
    for (VertexIndex i = 0; i + 1 < n; ++i) {
      const VertexIndex a = j * n + i, c = a + n;
      s.triangles.push_back({a, a + 1, c + 1});
      s.triangles.push_back({a, c + 1, c});
    }
  return s;
}

BuiltSurfaces built_of(std::vector<TriangulatedSurface> surfaces) {
  BuiltSurfaces built;
  built.surfaces = std::move(surfaces);
  built.rows.block_of_triangle.resize(built.surfaces.size());
  return built;
}

ModelRules rules_of_size(double size) {
  ModelRules rules;
  rules.column = {"sand", "mid", "shale", "base", "basement"};
  rules.surfaces.resize(3);
  rules.stack.size = size;
  rules.stack.outline = {{0, 0}, {width, 0}, {width, width}, {0, width}};
  return rules;
}

double flat(double, double) { return 0; }
double low(double, double) { return -500; }

/// 10 m over `flat` in the mean, and under it in islands of about `wave` / 2.
Height rough(double wave, double amplitude, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 2 * 3.141592653589793);
  const double a = uniform(random), b = uniform(random), turn = uniform(random);
  return [=](double x, double y) {
    const double u = std::cos(turn) * x - std::sin(turn) * y, v = std::sin(turn) * x + std::cos(turn) * y;
    return 10 + amplitude * std::sin(6.283185307179586 * u / wave + a) * std::sin(6.283185307179586 * v / wave + b);
  };
}

}  // namespace

TEST_CASE("a horizon over the column that crosses it in islands of few elements is settled with it", "[stack]") {
  for (unsigned seed = 0; seed < 8; ++seed) {
    BuiltSurfaces built = built_of({grid("mid", flat), grid("base", low), grid("relief", rough(700, 25, seed))});
    const Stack stack = find_stack(built, rules_of_size(500));
    CHECK(stack.rows == std::vector<Index>{2, 0, 1});
    CHECK(stack.units == std::vector<std::string>{"sand", "shale"});
    CHECK(stack.keepers == Keepers(3, Keeper::younger));
    REQUIRE(built.warnings.size() == 1);
    CHECK(built.warnings[0].find("relief is not in the column; it lies over mid") != std::string::npos);
  }
}

TEST_CASE("a horizon beside the column that crosses it in islands of many elements stays as it is", "[stack]") {
  for (unsigned seed = 0; seed < 8; ++seed) {
    BuiltSurfaces built = built_of({grid("mid", flat), grid("base", low), grid("water", rough(5000, 25, seed))});
    CHECK(find_stack(built, rules_of_size(150)).rows == std::vector<Index>{0, 1});
    CHECK(built.warnings.empty());
  }
}

TEST_CASE("horizons that lie apart from the column, between its horizons or under it are not settled with it",
          "[stack]") {
  const auto at = [](double z) { return [z](double, double) { return z; }; };
  for (const Height& height : {Height(at(100)), Height(at(-250)), Height(at(-900)),
                               Height([](double x, double y) { return rough(700, 25, 1)(x, y) - 520; })}) {
    BuiltSurfaces built = built_of({grid("mid", flat), grid("base", low), grid("other", height)});
    CHECK(find_stack(built, rules_of_size(500)).rows == std::vector<Index>{0, 1});
    CHECK(built.warnings.empty());
  }
}

TEST_CASE("a horizon is not put over a column whose topography is said, or that is given block by block", "[stack]") {
  BuiltSurfaces built = built_of({grid("mid", flat), grid("base", low), grid("relief", rough(700, 25, 3))});
  ModelRules rules = rules_of_size(500);
  rules.topography = "relief";
  CHECK(find_stack(built, rules).rows == std::vector<Index>{2, 0, 1});
  CHECK(built.warnings.empty());
  rules.topography.clear();
  built.rows.block_of_triangle[2].assign(built.surfaces[2].triangles.size(), 0);
  CHECK(find_stack(built, rules).rows == std::vector<Index>{0, 1});
}
