// SPDX-License-Identifier: GPL-3.0-or-later
// Triangulations of the map that grow where lines are an ulp apart. Found by seed 824102 of the random models
// (--light).
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "geomesh/core/predicates.hpp"
#include "stack/map/growing_triangulation.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

TEST_CASE("a line is halved beside another one whose middle rounds to the same place", "[stack]") {
  const double x = 432000, far = 435513.39611565962, y = 6513635.7969817296, below = std::nextafter(y, 0.0);
  LinedTriangulation start;
  start.points = {{x, below}, {far, y}, {x, y}, {433255, y + 1188}};
  start.triangles = {{0, 1, 2}, {2, 1, 3}};
  start.lined_sides = {7, 4};
  GrowingTriangulation map(start);
  GrowingTriangulation::Change change;
  map.add({433756, y + 1}, 1, 1, change);
  REQUIRE(change.vertex != no_vertex);
  CHECK(map.points()[change.vertex] == Vec2{0.5 * (x + far), y});
  for (Index c = 0; c < map.cells().size(); ++c) {
    const GrowingTriangulation::Cell& cell = map.cells()[c];
    const auto& v = cell.vertices;
    CHECK(orient2d(map.points()[v[0]], map.points()[v[1]], map.points()[v[2]]) == Sign::positive);
    for (std::size_t i = 0; i < 3; ++i) {
      if (cell.neighbours[i] == no_index) {
        CHECK(cell.lined[i]);
        continue;
      }
      const auto& back = map.cells()[cell.neighbours[i]].neighbours;
      CHECK(std::count(back.begin(), back.end(), c) == 1);
    }
  }
}
