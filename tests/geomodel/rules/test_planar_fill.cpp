// SPDX-License-Identifier: GPL-3.0-or-later
// The triangulation of the map depends on the places of the points alone, also where many lie on one circle.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <numeric>
#include <random>

#include "common/equal_points.hpp"
#include "rules/planar/borders.hpp"
#include "rules/planar/planar_fill.hpp"
#include "rules/planar/single_valued.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

/// Rows of `points` at the corners of each triangle, sorted. The points are handed over in the order given.
std::vector<std::array<Index, 3>> triangles_in_order(const std::vector<Vec2>& points, const std::vector<Index>& order) {
  std::vector<Vec2> moved;
  for (const Index row : order) moved.push_back(points[row]);
  const auto all = triangulate_plane(moved, {});
  REQUIRE(all);
  std::vector<std::array<Index, 3>> found;
  for (const PlanarTriangle& t : *all) {
    found.push_back({order[t.vertices[0]], order[t.vertices[1]], order[t.vertices[2]]});
    std::sort(found.back().begin(), found.back().end());
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

TEST_CASE("all squares of a grid have the diagonal that does not end at their last corner", "[rules]") {
  constexpr Index width = 40, height = 30;
  std::vector<Vec2> points;
  for (Index j = 0; j < height; ++j)
    for (Index i = 0; i < width; ++i) points.push_back({static_cast<double>(i), static_cast<double>(j)});
  std::vector<std::array<Index, 3>> expected;
  for (Index j = 0; j + 1 < height; ++j)
    for (Index i = 0; i + 1 < width; ++i) {
      const Index first = j * width + i;
      expected.push_back({first, first + 1, first + width});
      expected.push_back({first + 1, first + width, first + width + 1});
    }
  std::sort(expected.begin(), expected.end());
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::mt19937 random(3);
  for (int k = 0; k < 5; ++k) {
    CHECK(triangles_in_order(points, order) == expected);
    std::shuffle(order.begin(), order.end(), random);
  }
}

TEST_CASE("of twelve points on one circle each is an ear of those before it", "[rules]") {
  const std::vector<Vec2> points{{0, -5}, {-3, -4}, {3, -4}, {-4, -3}, {4, -3}, {-5, 0},
                                 {5, 0},  {-4, 3},  {4, 3},  {-3, 4},  {3, 4},  {0, 5}};  // by y, then x
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::vector<std::array<Index, 3>> expected;  // of the last point, its neighbours on the circle are the two before it
  for (Index v = 2; v < points.size(); ++v) expected.push_back({v - 2, v - 1, v});
  CHECK(triangles_in_order(points, order) == expected);
  std::reverse(order.begin(), order.end());
  CHECK(triangles_in_order(points, order) == expected);
}

/// Takes and gives back blocks of memory of random sizes, so that what is made next lies at other places.
void scatter(std::vector<std::vector<char>>& memory, std::mt19937& random) {
  for (int k = 0; k < 50; ++k) {
    std::vector<char> block(16 + random() % 5000);
    if (random() % 2 == 0) memory.push_back(std::move(block));
  }
  std::erase_if(memory, [&](const auto&) { return random() % 10 == 0; });
}

TEST_CASE("the order of the triangles does not depend on where in memory they are", "[rules]") {
  std::vector<Vec2> points;  // around a square hole of a grid
  for (int side = 0; side < 4; ++side)
    for (int i = 0; i < 3; ++i) {
      const double along = 4.7 + 0.3 * i, back = 5.6 - 0.3 * i;
      const std::array<Vec2, 4> places{{{along, 4.7}, {5.6, along}, {back, 5.6}, {4.7, back}}};
      points.push_back(places[side]);
    }
  const auto first = triangulate_plane(points, {});
  REQUIRE(first);
  std::mt19937 random(3);
  std::vector<std::vector<char>> memory;
  for (int k = 0; k < 100; ++k) {
    scatter(memory, random);
    const auto again = triangulate_plane(points, {});
    REQUIRE(again);
    REQUIRE(again->size() == first->size());
    for (std::size_t t = 0; t < first->size(); ++t) CHECK((*again)[t].vertices == (*first)[t].vertices);
  }
}

TEST_CASE("a triangle with two equal corners has no edges", "[rules]") {
  TriangulatedSurface square;
  square.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 0, 4}, {4, 2, 1}};  // the last two at a side and at another
  const std::vector<Triangle> merged = merged_triangles(square);
  REQUIRE(merged.size() == 4);
  for (const std::size_t t : {2u, 3u}) CHECK((merged[t][0] == merged[t][1] && merged[t][1] == merged[t][2]));
  CHECK(border_edges(square).size() == 4);
  CHECK(is_single_valued(square));
}
