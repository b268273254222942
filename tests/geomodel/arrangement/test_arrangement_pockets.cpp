// SPDX-License-Identifier: GPL-3.0-or-later
// Pockets that are thinner than the tolerance, and what stops just short of another surface.
#include <catch2/catch.hpp>

#include "arrangement/join/flatten_slivers.hpp"
#include "arrangement/pockets/shells.hpp"
#include "arrangement/snap/cracks.hpp"
#include "arrangement_inputs.hpp"
#include "dice.hpp"
#include "require_sound.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;

namespace {

ArrangementOptions where_they_meet(double tolerance) {
  ArrangementOptions options;
  options.tolerance = tolerance;
  options.merging = ArrangementOptions::MergingOf::surfaces_that_meet;
  return options;
}

arrangement::Complex complex_of(const PolygonSoup& soup) {
  arrangement::Complex complex;
  complex.points = soup.points;
  complex.facets = soup.facets;
  return complex;
}

/// Shells that see no facet from both sides.
std::size_t n_closed_shells(const PolygonSoup& soup) {
  const arrangement::Complex complex = complex_of(soup);
  std::size_t n = 0;
  for (const auto& shell : arrangement::shells_of(complex, arrangement::edge_facets(complex))) {
    bool is_closed = true;
    for (std::size_t k = 0; k + 1 < shell.size(); ++k)
      is_closed = is_closed && arrangement::facet_of(shell[k]) != arrangement::facet_of(shell[k + 1]);
    n += is_closed;
  }
  return n;
}

double double_area(const PolygonSoup& soup) {
  double sum = 0;
  for (Index f = 0; f < soup.facets.size(); ++f)
    if (soup.origin_offsets[f + 1] - soup.origin_offsets[f] == 2)
      sum += arrangement::area(soup.points[soup.facets[f][0]], soup.points[soup.facets[f][1]],
                               soup.points[soup.facets[f][2]]);
  return sum;
}

/// A flat floor and a bump that dips through it, `height` over it in the middle.
std::vector<TriangulatedSurface> floor_and_bump(double height) {
  return {grid_surface("floor", SurfaceKind::horizon, 12, 0, 10, 0, 10, [](double, double) { return 0.; }),
          grid_surface("bump", SurfaceKind::horizon, 13, 0, 10, 0, 10, [height](double x, double y) {
            const double r2 = (x - 5.03) * (x - 5.03) + (y - 4.96) * (y - 4.96);
            return height * (1 - r2 / 5) * (r2 < 9 ? 1 : 40);
          })};
}

}  // namespace

TEST_CASE("pockets: what is thinner than the tolerance closes, and both surfaces go on there", "[arrangement]") {
  const auto thin = floor_and_bump(0.004);
  CHECK(n_closed_shells(arrange(thin, {}, {}, {}).soup) == 1);
  const auto result = arrange(thin, {}, {}, where_they_meet(0.01));
  require_sound(result.soup);
  CHECK(result.merging.pockets_closed == 1);
  CHECK(n_closed_shells(result.soup) == 0);
  CHECK(double_area(result.soup) == Approx(3.14159 * 5).epsilon(0.05));
  for (const Index surface : {0, 1})
    CHECK(area_of(result.soup, surface) == Approx(area_of(arrange(thin, {}, {}, {}).soup, surface)).epsilon(0.001));
  CHECK(result.merging.displacement.largest > 0.002);
  CHECK(result.merging.displacement.largest < 0.005);
}

TEST_CASE("pockets: what is thicker than the tolerance stays", "[arrangement]") {
  const auto result = arrange(floor_and_bump(0.02), {}, {}, where_they_meet(0.01));
  require_sound(result.soup);
  CHECK(result.merging.pockets_closed == 0);
  CHECK(n_closed_shells(result.soup) == 1);
  CHECK(double_area(result.soup) == 0);
}

TEST_CASE("pockets: sides that face each other keep their orientation", "[arrangement]") {
  auto turned = floor_and_bump(0.004);
  for (Triangle& t : turned[1].triangles) std::swap(t[1], t[2]);
  const auto result = arrange(turned, {}, {}, where_they_meet(0.01));
  const PolygonSoup& soup = result.soup;
  std::size_t n_double = 0;
  for (Index f = 0; f < soup.facets.size(); ++f) {
    if (soup.origin_offsets[f + 1] - soup.origin_offsets[f] != 2) continue;
    ++n_double;
    CHECK(soup.origins[soup.origin_offsets[f]].reversed != soup.origins[soup.origin_offsets[f] + 1].reversed);
  }
  CHECK(n_double > 10);
}

TEST_CASE("pockets: what stays stands for both parts of one surface, which may be taken away one by one",
          "[arrangement]") {
  std::vector<TriangulatedSurface> one = floor_and_bump(0.004);
  const auto n_first = static_cast<VertexIndex>(one[0].points.size());
  std::vector<Index> part(one[0].triangles.size(), 0);
  one[0].points.insert(one[0].points.end(), one[1].points.begin(), one[1].points.end());
  for (const Triangle& t : one[1].triangles) {
    one[0].triangles.push_back({t[0] + n_first, t[1] + n_first, t[2] + n_first});
    part.push_back(1);
  }
  one.pop_back();
  ArrangementOptions options = where_they_meet(0.01);
  const auto as_one = arrange(one, {}, {}, options);
  CHECK(as_one.merging.pockets_closed == 1);
  CHECK(double_area(as_one.soup) == 0);
  options.parts = {part};
  const auto of_parts = arrange(one, {}, {}, options);
  require_sound(of_parts.soup);
  CHECK(of_parts.merging.pockets_closed == 1);
  CHECK(double_area(of_parts.soup) == Approx(3.14159 * 5).epsilon(0.05));
}

TEST_CASE("pockets: a well that passes through keeps its wall", "[arrangement]") {
  const Polyline well{"well", "", {{5.03, 4.96, -1}, {5.03, 4.96, 1}}};
  const auto result = arrange(floor_and_bump(0.004), {well}, {}, where_they_meet(0.01));
  require_sound(result.soup);
  CHECK(n_closed_shells(result.soup) + result.merging.pockets_closed == 1);
}

TEST_CASE("slits: an end of a surface beside vertices of its own is closed, once they are as near as asked",
          "[arrangement]") {
  // The needle between the edge 0-1 and the vertex 2 on it has vanished; 5 is far from all ends.
  const double off = GENERATE(1e-12, 0.1);
  arrangement::Complex complex;
  complex.points = {{0, 0, 0}, {3, 1, 0.5}, {1.5 - off, 0.5 + off, 0.25}, {1, 4, 0}, {2, -4, 1}, {9, 9, 9}};
  complex.facets = {{0, 1, 3}, {2, 0, 4}, {1, 2, 4}, {3, 1, 5}};
  for (Index f = 0; f < 4; ++f) complex.origins.push(std::vector<PolygonSoup::Origin>{{0, f, false}});
  complex.dirty_facet.assign(4, 0);
  complex.input_point.assign(6, no_index);
  std::vector<std::uint8_t> active(4, 0);
  arrangement::mark_cracks(complex, 1e-10, active);
  const bool is_slit = off < 1e-10;
  CHECK(active == (is_slit ? std::vector<std::uint8_t>{1, 1, 1, 0} : std::vector<std::uint8_t>(4, 0)));
  arrangement::Joining joining;
  joining.distance = 1e-10;
  CHECK(arrangement::flatten_slivers(complex, joining, {}, 1 << 30).changed() == is_slit);
  CHECK(complex.facets.size() == (is_slit ? 5 : 4));
}

TEST_CASE("shells: one for each space of random boxes, one for all that is outside", "[arrangement]") {
  for (const unsigned seed : {1u, 2u, 3u}) {
    Dice dice(seed);
    // Boxes side by side in a row share walls: n spaces, and what is around them.
    const auto n = 2 + dice.below(5);
    std::vector<TriangulatedSurface> walls;
    for (std::size_t k = 0; k <= n; ++k)
      walls.push_back(grid_surface("floor" + std::to_string(k), SurfaceKind::horizon, 4, 0, 10, 0, 10,
                                   [k](double, double) { return static_cast<double>(k); }));
    ArrangementOptions options;
    options.box = Box3{{1, 1, -1}, {9, 9, static_cast<double>(n) + 1}};
    CHECK(n_closed_shells(arrange(walls, {}, {}, options).soup) == n + 3);  // above, below and around
  }
}

TEST_CASE("tolerance: a wall that stops short of another that it never meets reaches it", "[arrangement]") {
  const auto wall = [](double from, double y) {
    TriangulatedSurface fault = triangles("wall", {{Vec3{from, y, 0}, Vec3{9, y, 0}, Vec3{9, y, 4}},
                                                   {Vec3{from, y, 0}, Vec3{9, y, 4}, Vec3{from, y, 4}}});
    fault.kind = SurfaceKind::fault;
    return fault;
  };
  const auto across = triangles(
      "across", {{Vec3{0, 0, -1}, Vec3{0, 9, -1}, Vec3{0, 9, 5}}, {Vec3{0, 0, -1}, Vec3{0, 9, 5}, Vec3{0, 0, 5}}});
  const auto reaches = arrange({across, wall(0.005, 4)}, {}, {}, where_they_meet(0.01));
  require_sound(reaches.soup);
  CHECK(reaches.merging.vertices_inserted > 0);
  const auto stays = arrange({across, wall(0.02, 4)}, {}, {}, where_they_meet(0.01));
  CHECK(stays.merging.vertices_inserted == 0);
}
