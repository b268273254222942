// SPDX-License-Identifier: GPL-3.0-or-later
// How far triangles reach from edges.
#include <catch2/catch.hpp>

#include "rules/planar/reach.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

TEST_CASE("the place of a triangle that is farthest from its sides is neither corner nor middle", "[rules]") {
  // The circle in it has a radius of 2. Corners and middles of sides are on the sides, the centroid is 1.54 off one.
  const std::array<Vec3, 3> triangle{{{0, 0, 0}, {12, 0, 0}, {0, 5, 0}}};
  const std::vector<EdgeEnds> sides{
      {{triangle[0], triangle[1]}}, {{triangle[1], triangle[2]}}, {{triangle[2], triangle[0]}}};
  CHECK(reaches_beyond(triangle, sides, 1.6));
  CHECK(reaches_beyond(triangle, sides, 1.95));
  CHECK_FALSE(reaches_beyond(triangle, sides, 2.1));
}

TEST_CASE("reach from one edge, from a part of it, and from none", "[rules]") {
  const std::array<Vec3, 3> triangle{{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}};
  const EdgeEnds side{{triangle[0], triangle[1]}}, part{{triangle[0], {1, 0, 0}}};
  CHECK_FALSE(reaches_beyond(triangle, {side}, 3));
  CHECK(reaches_beyond(triangle, {side}, 2.99));
  CHECK_FALSE(reaches_beyond(triangle, {part}, 3));
  CHECK(reaches_beyond(triangle, {part}, 2.99));
  CHECK(reaches_beyond(triangle, {}, 100));
  CHECK_FALSE(reaches_beyond(triangle, {{{triangle[0], triangle[0]}}}, 4));
}
