// SPDX-License-Identifier: GPL-3.0-or-later
// Bringing together what is near: `tolerance`, and overlaps too thin for any rounding.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <set>

#include "arrangement/snap/snap.hpp"
#include "arrangement_inputs.hpp"
#include "common_edges.hpp"
#include "geomesh/core/error.hpp"
#include "require_sound.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;

namespace {

ArrangementOptions within(double tolerance) {
  ArrangementOptions options;
  options.tolerance = tolerance;
  return options;
}

Vec3 unit(const Vec3& v) { return (1 / arrangement::length(v)) * v; }

}  // namespace

TEST_CASE("tolerance: a wall that stops just above a floor stands on it", "[arrangement]") {
  const auto floor = grid_surface("floor", SurfaceKind::horizon, 5, 0, 10, 0, 10, [](double, double) { return 0; });
  const auto wall = triangles("wall", {{Vec3{1, 5.1, 0.004}, Vec3{9, 5.3, 0.002}, Vec3{9, 5.3, 4}},
                                       {Vec3{1, 5.1, 0.004}, Vec3{9, 5.3, 4}, Vec3{1, 5.1, 4}}});
  CHECK(common_edges(arrange({floor, wall}, {}, {}, {}).soup, 0, 1).size() == 0);
  const auto result = arrange({floor, wall}, {}, {}, within(0.01));
  require_sound(result.soup);
  CHECK(common_edges(result.soup, 0, 1).size() > 4);
  CHECK(result.merging.vertices_inserted > 4);
  CHECK(result.merging.displacement.largest > 0.001);
  CHECK(result.merging.displacement.largest < 0.05);
  CHECK(area_of(result.soup, 0) == Approx(100).epsilon(1e-3));
}

TEST_CASE("tolerance: surfaces that nearly coincide become one", "[arrangement]") {
  const auto shape = [](double lift) { return [lift](double x, double y) { return 0.1 * x * x - 0.2 * y + lift; }; };
  const auto a = grid_surface("a", SurfaceKind::horizon, 8, 0, 10, 0, 10, shape(0)),
             b = grid_surface("b", SurfaceKind::horizon, 8, 0, 10, 0, 10, shape(0.003));
  CHECK(arrange({a, b}, {}, {}, {}).soup.facets.size() == 256);
  const auto result = arrange({a, b}, {}, {}, within(0.01));
  require_sound(result.soup);
  CHECK(result.soup.facets.size() == 128);
  CHECK(result.soup.origins.size() == 256);
  CHECK(result.merging.vertices_merged == 81);
  CHECK(result.merging.facets_merged == 128);
  CHECK(result.soup.points.size() == 81);
  const auto merged =
      std::find_if(result.spots.begin(), result.spots.end(), [](const Spot& s) { return s.what == "merged"; });
  REQUIRE(merged != result.spots.end());
  CHECK(merged->surface_a == 0);
  CHECK(merged->surface_b == 1);
  CHECK(merged->count == 128);
  CHECK(merged->measure == Approx(area_of(result.soup, 0)));
  CHECK(std::any_of(result.warnings.begin(), result.warnings.end(), [](const std::string& w) {
    return w.find("a and horizon b were merged over") != std::string::npos;
  }));
  CHECK(std::none_of(result.spots.begin(), result.spots.end(), [](const Spot& s) { return s.what == "overlap"; }));
}

TEST_CASE("merging: facets that lose their area are counted by surface", "[arrangement]") {
  const auto needle = triangles(
      "needle", {{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}, {Vec3{3, 0, 0}, Vec3{4, 0, 0}, Vec3{3.5, 0.001, 0}}});
  const auto result = arrange({needle}, {}, {}, within(0.01));
  const auto vanished =
      std::find_if(result.spots.begin(), result.spots.end(), [](const Spot& s) { return s.what == "vanished"; });
  REQUIRE(vanished != result.spots.end());
  CHECK(vanished->surface_a == 0);
  CHECK(vanished->count == 1);
  CHECK(vanished->count == result.merging.facets_collapsed);
  CHECK(describe(*vanished, {needle}).find("surface needle: 1 facets too thin") == 0);
}

TEST_CASE("tolerance: a surface that stops just short of the box goes to it", "[arrangement]") {
  auto options = within(0.01);
  options.box = Box3{{0, 0, -5}, {10, 10, 5}};
  const auto top =
      grid_surface("top", SurfaceKind::horizon, 4, 0.003, 9.998, -1, 11, [](double x, double) { return 0.1 * x; });
  const auto result = arrange({top}, {}, {}, options);
  require_sound(result.soup);
  CHECK(std::none_of(result.spots.begin(), result.spots.end(), [](const Spot& s) { return s.what == "free border"; }));
  options.tolerance = 0;
  const auto strict = arrange({top}, {}, {}, options);
  CHECK(std::any_of(strict.spots.begin(), strict.spots.end(), [](const Spot& s) { return s.what == "free border"; }));
}

namespace {

double length_of(const Vec3& v) { return std::sqrt(dot(v, v)); }

double shortest_edge(const PolygonSoup& soup) {
  double shortest = 1e300;
  for (const Triangle& t : soup.facets)
    for (std::size_t k = 0; k < 3; ++k)
      shortest = std::min(shortest, length_of(soup.points[t[k]] - soup.points[t[(k + 1) % 3]]));
  return shortest;
}

ArrangementOptions where_surfaces_meet_within(double tolerance) {
  ArrangementOptions options = within(tolerance);
  options.merging = ArrangementOptions::MergingOf::surfaces_that_meet;
  return options;
}

}  // namespace

TEST_CASE("merging where surfaces meet: a wall that overshoots a floor by less than the tolerance ends on it",
          "[arrangement]") {
  const auto floor = grid_surface("floor", SurfaceKind::horizon, 5, 0, 10, 0, 10, [](double, double) { return 0; });
  const auto wall = triangles("wall", {{Vec3{1, 5.1, -0.004}, Vec3{9, 5.3, -0.002}, Vec3{9, 5.3, 4}},
                                       {Vec3{1, 5.1, -0.004}, Vec3{9, 5.3, 4}, Vec3{1, 5.1, 4}}});
  CHECK(shortest_edge(arrange({floor, wall}, {}, {}, {}).soup) < 0.01);
  const auto result = arrange({floor, wall}, {}, {}, where_surfaces_meet_within(0.01));
  require_sound(result.soup);
  CHECK(shortest_edge(result.soup) > 0.01);
  CHECK(common_edges(result.soup, 0, 1).size() > 4);
  CHECK(result.merging.displacement.largest < 0.03);
}

TEST_CASE("merging where surfaces meet: surfaces that meet nowhere stay apart, and fine triangles stay",
          "[arrangement]") {
  const auto a = grid_surface("a", SurfaceKind::horizon, 8, 0, 10, 0, 10, [](double x, double) { return 0.1 * x; }),
             b = grid_surface("b", SurfaceKind::horizon, 8, 0, 10, 0, 10,
                              [](double x, double) { return 0.1 * x + 0.003; }),
             fine = grid_surface("fine", SurfaceKind::horizon, 9, 4, 4.05, 4, 4.05, [](double, double) { return 9; });
  const auto result = arrange({a, b, fine}, {}, {}, where_surfaces_meet_within(0.01));
  require_sound(result.soup);
  CHECK(result.soup.facets.size() == 2 * 128 + 162);
  CHECK(result.merging.vertices_merged + result.merging.vertices_inserted == 0);
}

TEST_CASE("merging where surfaces meet: borders that end short of the box go to it, surfaces along its sides stay",
          "[arrangement]") {
  auto options = where_surfaces_meet_within(0.01);
  options.box = Box3{{0, 0, -5}, {10, 10, 5}};
  const auto top =
      grid_surface("top", SurfaceKind::horizon, 4, 0.003, 9.998, -1, 11, [](double, double) { return 4.995; });
  const auto result = arrange({top}, {}, {}, options);
  require_sound(result.soup);
  CHECK(std::none_of(result.spots.begin(), result.spots.end(), [](const Spot& s) { return s.what == "free border"; }));
  CHECK(area_of(result.soup, 0) == Approx(100));
  CHECK(std::none_of(result.spots.begin(), result.spots.end(), [](const Spot& s) { return s.what == "merged"; }));
}

TEST_CASE("tolerance: crossing surfaces and a well keep their curves", "[arrangement]") {
  const auto a = grid_surface("a", SurfaceKind::horizon, 20, 0, 10, 0, 10,
                              [](double x, double y) { return std::sin(x) + 0.1 * y; });
  const auto b = grid_surface("b", SurfaceKind::horizon, 17, 0, 10, 0, 10,
                              [](double x, double y) { return std::cos(y) + 0.1 * x; });
  const Polyline well{"well", "", {{5, 5, -4}, {5.1, 4.9, 4}}};
  const auto result = arrange({a, b}, {well}, {}, within(0.02));
  require_sound(result.soup);
  CHECK(common_edges(result.soup, 0, 1).size() > 20);
  CHECK(result.soup.segments.size() >= 3);
  CHECK(area_of(result.soup, 0) == Approx(area_of(a)).epsilon(0.01));
  CHECK(result.rounding.largest < 1e-13);
}

TEST_CASE("tolerance: below what rounding needs it is refused", "[arrangement]") {
  const auto floor = grid_surface("floor", SurfaceKind::horizon, 2, 0, 1e6, 0, 1e6, [](double, double) { return 0; });
  CHECK_THROWS_AS(arrange({floor}, {}, {}, within(1e-12)), Error);
}

TEST_CASE("arrange: integer-grid soups turned by odd angles", "[arrangement]") {
  // Turned, exact overlaps become overlaps a few ulps thick.
  double worst = 0;
  for (unsigned seed = 0; seed < 120; ++seed) {
    INFO("seed " << seed);
    const RandomSoup soup = turned(random_soup(seed), 0.37);
    const auto result = arrange(soup.surfaces, soup.polylines, soup.points, soup.options);
    require_sound(result.soup);
    worst =
        std::max(worst, ulps_of_largest(result.soup, result.merging.displacement.largest + result.rounding.largest));
  }
  CHECK(worst <= 64);
}

TEST_CASE("arrange: 1000 integer-grid soups turned by an odd angle", "[arrangement][nightly]") {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    INFO("seed " << seed);
    const RandomSoup soup = turned(random_soup(seed), 0.37);
    require_sound(arrange(soup.surfaces, soup.polylines, soup.points, soup.options).soup);
  }
}

TEST_CASE("arrange: surfaces that lie in each other to rounding are one where both are", "[arrangement]") {
  // Sheets of n by n squares of one plane, far from the origin: their points are up to an ulp off it.
  const auto sheet = [](const std::string& name, int n, double from, double to) {
    const auto place = [&](int i, int j) {
      const double u = from + (to - from) * i / n, v = from + (to - from) * j / n;
      return Vec3{7.1e6 + 83.1 * u - 31.7 * v, 1.2e7 + 29.3 * u + 71.9 * v, -2000 + 41.3 * u + 57.7 * v};
    };
    std::vector<std::array<Vec3, 3>> all;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        all.push_back({place(i, j), place(i + 1, j), place(i + 1, j + 1)});
        all.push_back({place(i, j), place(i + 1, j + 1), place(i, j + 1)});
      }
    return triangles(name, all, SurfaceKind::fault);
  };
  const auto result = arrange({sheet("a", 7, 0, 10), sheet("b", 5, 2.3, 7.9)}, {}, {}, ArrangementOptions{});
  require_sound(result.soup);
  const auto area = [](const std::array<Vec3, 3>& t) {
    const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
    return 0.5 * std::sqrt(dot(n, n));
  };
  double of_both = 0, of_b = 0;
  for (Index f = 0; f < result.soup.facets.size(); ++f) {
    const auto& t = result.soup.facets[f];
    const double own = area({result.soup.points[t[0]], result.soup.points[t[1]], result.soup.points[t[2]]});
    bool is_a = false, is_b = false;
    for (Index k = result.soup.origin_offsets[f]; k < result.soup.origin_offsets[f + 1]; ++k)
      (result.soup.origins[k].surface == 0 ? is_a : is_b) = true;
    if (is_b) of_b += own;
    if (is_a && is_b) of_both += own;
  }
  CHECK(of_both == Approx(of_b).epsilon(1e-9));
}

TEST_CASE("diagnosis: horizons that cross, a gap and a loose end in words", "[arrangement]") {
  ArrangementOptions options;
  options.box = Box3{{0, 0, -2000}, {4000, 4000, 0}};
  // The upper horizon dips through the lower one over a strip of 4 km by 1.23 km.
  const auto upper = grid_surface("top_chalk", SurfaceKind::horizon, 8, -500, 4500, -500, 4500, [](double x, double) {
    return x > 3000 ? -1000 - 0.5 * (x - 3000) : -900 - 0.1 * (x - 2000);
  });
  auto lower = grid_surface("base_chalk", SurfaceKind::horizon, 20, -500, 4500, -500, 4500,
                            [](double, double) { return -1000; });
  lower.triangles.erase(lower.triangles.begin() + 2 * (20 * 10 + 5), lower.triangles.begin() + 2 * (20 * 10 + 7));
  const auto fault =
      triangles("f1", {{Vec3{1000, 500, -100}, Vec3{1000, 1500, -100}, Vec3{1000, 1000, -400}}}, SurfaceKind::fault);
  const auto result = arrange({upper, lower, fault}, {}, {}, options);
  require_sound(result.soup);
  const auto lines = findings(result.spots, {upper, lower, fault});
  const auto says = [&lines](const std::string& text) {
    return std::any_of(lines.begin(), lines.end(),
                       [&](const std::string& line) { return line.find(text) != std::string::npos; });
  };
  for (const std::string& line : lines) UNSCOPED_INFO(line);
  CHECK(says("horizon top_chalk crosses horizon base_chalk over 4.92 km2 along 4 km near (2769.23"));
  CHECK(says("horizon base_chalk has a gap: a hole with a border of 1.5 km near"));
  CHECK(says("fault f1 ends inside the model (tip line) along 2.17 km near"));
}

TEST_CASE("snapping: edges that join where a facet beside them has a corner take that corner", "[arrangement]") {
  constexpr double apart = 0x1p-20;
  arrangement::Complex complex;
  complex.points = {{-1, 0, 0},        {1, 0, 0},     {0, -3, -1},  // its first edge passes under that of the next one
                    {0, -1, apart},    {0, 1, apart}, {3, 0, 1},
                    {0, 0, apart / 2}, {-2, 2, 2},    {-2, -2, 2}};  // a corner exactly half-way between
  complex.input_point.assign(complex.points.size(), no_index);
  for (VertexIndex v = 0; v < 9; v += 3) {
    complex.facets.push_back({v, v + 1, v + 2});
    complex.origins.push(std::vector{arrangement::Origin{v / 3, 0, false}});
  }
  complex.dirty_facet.assign(3, 1);
  const auto outcome = arrangement::snap_near(complex, {1, 1, 0}, {2 * apart, std::nullopt});
  CHECK(outcome.n_vertices_inserted == 2);
  CHECK(complex.facets.size() == 5);
  std::set<std::array<double, 3>> places;
  for (const Vec3& p : complex.points) places.insert({p.x, p.y, p.z});
  CHECK(places.size() == complex.points.size());
}

TEST_CASE("snapping: long edges of one plane that cross get a common vertex, however small the angle",
          "[arrangement]") {
  constexpr double size = 6000, ulp = 0x1p-40;  // of coordinates to 8192
  std::mt19937 chance(7);
  std::uniform_real_distribution<double> any(-1, 1);
  for (const double angle : {1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5})
    for (int k = 0; k < 100; ++k) {
      const auto direction = [&] { return unit({any(chance), any(chance), any(chance)}); };
      const Vec3 normal = direction(), along = unit(cross(normal, direction()));
      const Vec3 turned = std::cos(angle) * along + std::sin(angle) * cross(normal, along);
      const Vec3 middle{size, size, size / 2};
      arrangement::Complex complex;
      complex.points = {middle - 700 * along,  middle + 900 * along,  middle + 500 * normal,
                        middle - 800 * turned, middle + 600 * turned, middle - 500 * normal};
      complex.input_point.assign(6, no_index);
      for (VertexIndex v = 0; v < 6; v += 3) {
        complex.facets.push_back({v, v + 1, v + 2});
        complex.origins.push(std::vector{arrangement::Origin{v / 3, 0, false}});
      }
      complex.dirty_facet.assign(2, 1);
      INFO("angle " << angle << ", plane " << k);
      CHECK(arrangement::snap_near(complex, {1, 1}, {32 * ulp, std::nullopt}).n_vertices_inserted == 2);
      CHECK(complex.facets.size() == 4);
    }
}

TEST_CASE("snapping: a vertex inside of a thin facet is put in it, however thin it is", "[arrangement]") {
  constexpr double size = 6000, ulp = 0x1p-40;
  std::mt19937 chance(8);
  std::uniform_real_distribution<double> any(-1, 1);
  for (const double width : {10.0, 1.0, 1e-2, 1e-4, 1e-6})
    for (int k = 0; k < 100; ++k)
      for (const bool is_needle : {false, true}) {
        const auto direction = [&] { return unit({any(chance), any(chance), any(chance)}); };
        const Vec3 normal = direction(), along = unit(cross(normal, direction())), across = cross(normal, along);
        const Vec3 a{size, size, size / 2}, b = a + 1500 * along,
                                            c = (is_needle ? a : a + 700 * along) + width * across;
        const Vec3 inside = 0.3 * a + 0.3 * b + 0.4 * c;
        arrangement::Complex complex;
        complex.points = {a, b, c, inside, inside + Vec3{40, 60, 80}, inside + Vec3{-70, 20, 60}};
        complex.input_point.assign(6, no_index);
        for (VertexIndex v = 0; v < 6; v += 3) {
          complex.facets.push_back({v, v + 1, v + 2});
          std::rotate(complex.facets.back().begin(), complex.facets.back().begin() + k % 3,
                      complex.facets.back().end());
          complex.origins.push(std::vector{arrangement::Origin{v / 3, 0, false}});
        }
        complex.dirty_facet.assign(2, 1);
        INFO("width " << width << ", plane " << k << (is_needle ? ", needle" : ", cap"));
        arrangement::snap_near(complex, {1, 1}, {32 * ulp, std::nullopt});
        CHECK(std::count_if(complex.facets.begin(), complex.facets.end(), [](const Triangle& t) {
                return std::find(t.begin(), t.end(), VertexIndex{3}) != t.end();
              }) == 4);
      }
}

TEST_CASE("split_facet: vertices on the border and inside", "[arrangement]") {
  using arrangement::split_facet;
  const std::vector<Vec3> p{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {2, 1e-9, 0}, {1, 1, 1e-9}, {2, 2, 0}};
  const auto area_of_pieces = [&](const std::vector<Triangle>& pieces) {
    double sum = 0;
    for (const auto& [a, b, c] : pieces) sum += 0.5 * cross(p[b] - p[a], p[c] - p[a]).z;
    return sum;
  };
  const auto plain = split_facet(p, {0, 1, 2}, {0, 3, 1, 5, 2}, {4}, {{3, 5}});
  REQUIRE(plain);
  CHECK(plain->size() == 5);
  CHECK(area_of_pieces(*plain) == Approx(8).epsilon(1e-8));
  const auto turned_round = split_facet(p, {0, 2, 1}, {0, 2, 5, 1, 3}, {}, {});
  REQUIRE(turned_round);
  CHECK(area_of_pieces(*turned_round) == Approx(-8).epsilon(1e-8));
  const auto collapsed = split_facet(p, {0, 1, 3}, {0, 3, 1, 3}, {}, {});
  REQUIRE(collapsed);
  CHECK(collapsed->empty());
}

TEST_CASE("snapping: a facet follows a vertex that is beyond its edge as seen along an axis", "[arrangement]") {
  // The edge 0 2 and the vertex 3 beside it are in a plane x = 0. Seen along y, 3 comes after 2 on the same line.
  const std::vector<Vec3> points{{0, -168, -210}, {51, 0, -2}, {0, 9.5, -0.2}, {0, 0, 0}};
  const auto triangles = arrangement::split_facet(points, {0, 1, 2}, {0, 1, 2, 3}, {}, {});
  REQUIRE(triangles);
  std::set<std::pair<VertexIndex, VertexIndex>> edges;
  for (const Triangle& t : *triangles)
    for (std::size_t k = 0; k < 3; ++k) edges.emplace(t[k], t[(k + 1) % 3]);
  CHECK(edges.contains({2, 3}));
  CHECK(edges.contains({3, 0}));
}
