// SPDX-License-Identifier: GPL-3.0-or-later
// Which horizons are settled together.
#include <catch2/catch.hpp>
#include <functional>

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

}  // namespace

TEST_CASE("a topography that the column does not name is settled with it, another horizon is not", "[stack]") {
  const auto above = [](double, double) { return 10.0; };
  BuiltSurfaces built = built_of({grid("mid", flat), grid("base", low), grid("relief", above)});
  ModelRules rules = rules_of_size(500);
  CHECK(find_stack(built, rules).rows == std::vector<Index>{0, 1});
  rules.topography = "relief";
  const Stack stack = find_stack(built, rules);
  CHECK(stack.rows == std::vector<Index>{2, 0, 1});
  CHECK(stack.units == std::vector<std::string>{"sand", "shale"});
  CHECK(stack.keepers == Keepers(3, Keeper::younger));
}
