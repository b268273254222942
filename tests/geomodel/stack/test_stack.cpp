// SPDX-License-Identifier: GPL-3.0-or-later
// Horizons that touch, cross and thin out by noise, settled in the map.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <set>

#include "geomesh/core/predicates.hpp"
#include "geomesh/geomodel/model_rules.hpp"
#include "naming/name_regions.hpp"
#include "rules/order/column_heights.hpp"
#include "rules/planar/map_locator.hpp"
#include "rules/planar/planar_lines.hpp"
#include "rules/planar/single_valued.hpp"
#include "stack/map/growing_triangulation.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
constexpr double width = 10000;

/// A grid of n by n nodes from -500 to width + 500 with uniform noise.
TriangulatedSurface grid(const std::string& name, int n, const std::function<double(double, double)>& height,
                         double noise, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-noise, noise);
  TriangulatedSurface s;
  s.name = name;
  s.kind = SurfaceKind::horizon;
  const double step = (width + 1000) / (n - 1);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const double x = -500 + step * i, y = -500 + step * j;
      s.points.push_back({x, y, height(x, y) + uniform(random)});
    }
  for (int j = 0; j + 1 < n; ++j)
    for (int i = 0; i + 1 < n; ++i) {
      const auto a = static_cast<VertexIndex>(j * n + i), c = a + static_cast<VertexIndex>(n);
      s.triangles.push_back({a, a + 1, c + 1});
      s.triangles.push_back({a, c + 1, c});
    }
  return s;
}

/// The unit between thins out to nothing at x = 5000; beyond, the horizons touch and cross by noise.
double upper(double x, double y) { return 100 * std::sin(x / 1500) * std::cos(y / 2000); }
double thickness(double x, double) { return std::max(0.0, 0.1 * (5000 - x)); }
double middle(double x, double y) { return upper(x, y) - thickness(x, y); }
double lower(double x, double y) { return upper(x, y) - 800; }

std::vector<TriangulatedSurface> noisy_stack(double noise) {
  return {grid("top", 111, upper, noise, 1), grid("mid", 111, middle, noise, 2), grid("base", 111, lower, noise, 3)};
}

ModelRules stack_rules() {
  ModelRules rules;
  rules.column = {"air", "top", "sand", "mid", "shale", "base", "basement"};
  rules.box = Box3{{0, 0, -3000}, {width, width, 1000}};
  rules.stack.size = 500;
  rules.stack.tolerance = 20;
  rules.stack.outline = {{0, 0}, {width, 0}, {width, width}, {0, width}};
  rules.stack.outline_is_box = true;
  return rules;
}

double area_in_map(const TriangulatedSurface& s, const Triangle& t) {
  const Vec3 n = cross(s.points[t[1]] - s.points[t[0]], s.points[t[2]] - s.points[t[0]]);
  return 0.5 * n.z;
}

std::set<std::array<double, 9>> triangles_of(const TriangulatedSurface& s) {
  std::set<std::array<double, 9>> result;
  for (const Triangle& t : s.triangles) {
    std::array<std::array<double, 3>, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = {s.points[t[i]].x, s.points[t[i]].y, s.points[t[i]].z};
    std::sort(corners.begin(), corners.end());
    std::array<double, 9> key;
    for (std::size_t i = 0; i < 9; ++i) key[i] = corners[i / 3][i % 3];
    result.insert(key);
  }
  return result;
}

}  // namespace

TEST_CASE("heights of a stack are put in order by the horizons that keep their place", "[stack]") {
  const Keepers younger(3, Keeper::younger), older(3, Keeper::older);
  std::vector<double> h{10, 12, 3};
  settle_column(h, 0, younger, 1);
  CHECK(h == std::vector<double>{10, 9, 3});
  h = {10, 12, 3};
  settle_column(h, 0, older, 1);
  CHECK(h == std::vector<double>{13, 12, 3});
  h = {10, 8, 3};
  settle_column(h, 1, older, 1);
  CHECK(h == std::vector<double>{8, 8, 3});
  h = {10, 8, 9};
  settle_column(h, 3, younger, 1);
  CHECK(h == std::vector<double>{10, 10, 10});
}

TEST_CASE("horizons of a stack are put in order as they were laid down", "[stack]") {
  Keepers keepers(4, Keeper::younger);  // h3 is onlapped by all that is younger, h1 by h0
  for (std::size_t younger = 0; younger < 3; ++younger) keepers.set(younger, 3, Keeper::older);
  keepers.set(0, 1, Keeper::older);
  std::vector<double> h{7, 3, 3.5, 5};
  settle_column(h, 0, keepers, 0);
  CHECK(h == std::vector<double>{7, 5, 5, 5});
  h = {2, 3, 3.5, 1};
  settle_column(h, 0, keepers, 0);
  CHECK(h == std::vector<double>{3, 3, 3, 1});
  Keepers eroded(3, Keeper::older);  // h1 erodes h2, onto which h0 would be laid
  eroded.set(1, 2, Keeper::younger);
  h = {2, 1, 4};
  settle_column(h, 0, eroded, 0);
  CHECK(h == std::vector<double>{2, 1, 1});
}

TEST_CASE("a horizon that is absent lets its neighbours meet in a settled stack", "[stack]") {
  const Keepers keepers(3, Keeper::younger);
  std::vector<double> h{10, nan_value, 12};
  settle_column(h, 0, keepers, 1);
  CHECK(h[2] == 9);
  h = {10, nan_value, 12};
  settle_column(h, 3, keepers, 1);
  CHECK(h[2] == 10);
  h = {10, nan_value, 12};
  settle_column(h, 1, keepers, 1);
  CHECK(h[2] == 9);
}

TEST_CASE("points added to a triangulation of the map keep it constrained Delaunay", "[stack]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  const std::vector<Vec2> line{{0, 0.3}, {0.4, 0.5}, {1, 0.45}};
  GrowingTriangulation map(triangulate_lines({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {line}));
  REQUIRE(map.n_zones() == 2);
  GrowingTriangulation::Change change;
  for (int k = 0; k < 500; ++k) {
    const Vec2 p{uniform(random), uniform(random)};
    const Index at = map.locate(p, 0);
    REQUIRE(at != no_index);
    map.add(p, at, 1e-3, change);
  }
  double area = 0;
  std::vector<double> of_zone(2, 0.0);
  for (Index c = 0; c < map.cells().size(); ++c) {
    const GrowingTriangulation::Cell& cell = map.cells()[c];
    const Vec2 &a = map.points()[cell.vertices[0]], &b = map.points()[cell.vertices[1]],
               &d = map.points()[cell.vertices[2]];
    REQUIRE(orient2d(a, b, d) == Sign::positive);
    area += 0.5 * ((b.x - a.x) * (d.y - a.y) - (b.y - a.y) * (d.x - a.x));
    of_zone[cell.zone] += 0.5 * ((b.x - a.x) * (d.y - a.y) - (b.y - a.y) * (d.x - a.x));
    for (std::size_t i = 0; i < 3; ++i) {
      const Index n = cell.neighbours[i];
      if (n == no_index) continue;
      const auto& back = map.cells()[n].neighbours;
      REQUIRE(std::count(back.begin(), back.end(), c) == 1);
      if (cell.lined[i]) continue;
      for (const VertexIndex v : map.cells()[n].vertices)
        if (std::count(cell.vertices.begin(), cell.vertices.end(), v) == 0)
          REQUIRE(in_circle(a, b, d, map.points()[v]) != Sign::positive);
    }
  }
  CHECK(area == Approx(1).epsilon(1e-12));
  // The line's area below it: 0.4 * 0.4 + 0.6 * 0.475.
  CHECK(std::min(of_zone[0], of_zone[1]) == Approx(0.445).epsilon(1e-9));
}

TEST_CASE("lines of the map that cross each other are all in its triangulation", "[stack]") {
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    const auto place = [&] {
      const double x = uniform(random);
      return Vec2{x, uniform(random)};
    };
    std::vector<Vec2> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (unsigned k = 0; k < 30 * (seed % 4); ++k) points.push_back(place());
    std::vector<std::vector<Vec2>> lines;
    double length = 0, lined = 0;
    for (int k = 0; k < 30; ++k) {
      const Vec2 a = place(), b = place();
      lines.push_back({a, b});
      length += std::hypot(a.x - b.x, a.y - b.y);
    }
    const LinedTriangulation t = triangulate_lines(points, lines);
    for (std::size_t f = 0; f < t.triangles.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec2 &p = t.points[t.triangles[f][(i + 1) % 3]], &q = t.points[t.triangles[f][(i + 2) % 3]];
        if (t.lined_sides[f] >> i & 1) lined += 0.5 * std::hypot(p.x - q.x, p.y - q.y);
      }
    REQUIRE(lined == Approx(length).epsilon(1e-9));
  }
}

TEST_CASE("horizons that touch and cross by noise are settled without a crossing", "[stack]") {
  const std::vector<TriangulatedSurface> given = noisy_stack(4);
  const BuiltSurfaces built = build_surfaces(given, stack_rules());
  REQUIRE(built.stack.settled);
  const TriangulatedSurface &top = built.surfaces[0], &mid = built.surfaces[1], &base = built.surfaces[2];
  REQUIRE(top.points.size() == mid.points.size());
  REQUIRE(top.triangles == mid.triangles);
  REQUIRE(top.triangles == base.triangles);
  std::size_t n_shared = 0;
  for (std::size_t v = 0; v < top.points.size(); ++v) {
    REQUIRE(top.points[v].x == mid.points[v].x);
    REQUIRE(top.points[v].y == mid.points[v].y);
    REQUIRE(top.points[v].z >= mid.points[v].z);
    REQUIRE(mid.points[v].z > base.points[v].z);
    n_shared += top.points[v].z == mid.points[v].z;
  }
  CHECK(n_shared > top.points.size() / 3);
  CHECK(top.triangles.size() < given[0].triangles.size() / 5);
}

TEST_CASE("settled horizons share the triangles of the area where the unit between is too thin", "[stack]") {
  const BuiltSurfaces built = build_surfaces(noisy_stack(4), stack_rules());
  REQUIRE(built.stack.settled);
  const auto top = triangles_of(built.surfaces[0]), mid = triangles_of(built.surfaces[1]);
  double shared = 0;
  for (const Triangle& t : built.surfaces[0].triangles) {
    std::array<double, 9> key{};
    std::array<std::array<double, 3>, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& p = built.surfaces[0].points[t[i]];
      corners[i] = {p.x, p.y, p.z};
    }
    std::sort(corners.begin(), corners.end());
    for (std::size_t i = 0; i < 9; ++i) key[i] = corners[i / 3][i % 3];
    if (mid.count(key)) shared += area_in_map(built.surfaces[0], t);
  }
  CHECK(shared == Approx(built.stack.units[0].area_merged).epsilon(1e-9));
  // Thinner than 10 m east of x = 4900, on an edge of the size asked more or less.
  CHECK(shared == Approx(5100 * width).margin(300 * width));
  CHECK(built.stack.units[0].pinch_outs.size() == 1);
  CHECK(built.stack.units[1].area_merged == 0);
}

TEST_CASE("settled horizons keep to their data within half of the tolerance outside of shared areas", "[stack]") {
  const std::vector<TriangulatedSurface> given = noisy_stack(4);
  const BuiltSurfaces built = build_surfaces(given, stack_rules());
  REQUIRE(built.stack.settled);
  for (const SettledHorizon& h : built.stack.horizons) CHECK(h.largest_off <= 10 * (1 + 1e-9));
  CHECK(built.stack.horizons[0].area_moved == 0);
  CHECK(built.stack.horizons[2].area_moved == 0);
  CHECK(built.stack.horizons[1].largest_move < 30);
}

TEST_CASE("settling a stack makes no edges much shorter than the data's points are apart", "[stack]") {
  const BuiltSurfaces built = build_surfaces(noisy_stack(4), stack_rules());
  REQUIRE(built.stack.settled);
  const TriangulatedSurface& top = built.surfaces[0];
  double shortest = width;
  for (const Triangle& t : top.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 d = top.points[t[i]] - top.points[t[(i + 1) % 3]];
      shortest = std::min(shortest, std::hypot(d.x, d.y));
    }
  CHECK(shortest > 15);  // points are 100 m apart
}

TEST_CASE("a unit that thins out at a fraction of a degree ends steeply in a settled stack, and is nowhere thinner",
          "[stack]") {
  const auto flat = [](double x, double y) { return upper(x, y) - std::max(0.0, 0.008 * (6000 - x)); };
  const BuiltSurfaces built = build_surfaces(
      {grid("top", 111, upper, 1, 1), grid("mid", 111, flat, 1, 2), grid("base", 111, lower, 1, 3)}, stack_rules());
  REQUIRE(built.stack.settled);
  const TriangulatedSurface &top = built.surfaces[0], &mid = built.surfaces[1];
  const double least = built.stack.min_thickness;
  std::size_t n_closing = 0;
  for (const Triangle& t : top.triangles) {
    std::array<double, 3> thick{};
    for (std::size_t i = 0; i < 3; ++i) {
      thick[i] = top.points[t[i]].z - mid.points[t[i]].z;
      REQUIRE((thick[i] == 0 || thick[i] >= least * (1 - 1e-9)));
    }
    const auto [thinnest, thickest] = std::minmax_element(thick.begin(), thick.end());
    if (*thinnest != 0 || *thickest == 0) continue;
    ++n_closing;
    const auto in_map = [&](std::size_t i) {
      return Vec2{top.points[t[i]].x - top.points[t[0]].x, top.points[t[i]].y - top.points[t[0]].y};
    };
    const Vec2 u = in_map(1), w = in_map(2);
    const double du = thick[1] - thick[0], dw = thick[2] - thick[0], det = u.x * w.y - u.y * w.x;
    REQUIRE(std::hypot(du * w.y - dw * u.y, dw * u.x - du * w.x) / det > 1.0 / 13);  // the grids open by 0.008
  }
  CHECK(n_closing > 20);
}

TEST_CASE("thin units of a settled stack ask for edges that are not long against their thickness", "[stack]") {
  const auto flat = [](double x, double y) { return upper(x, y) - std::max(0.0, 0.008 * (6000 - x)); };
  const BuiltSurfaces built = build_surfaces(
      {grid("top", 111, upper, 1, 1), grid("mid", 111, flat, 1, 2), grid("base", 111, lower, 1, 3)}, stack_rules());
  REQUIRE(built.stack.settled);
  REQUIRE(!built.stack.sizes.empty());
  for (const SizeSource& s : built.stack.sizes) {
    REQUIRE(s.size >= 24 * built.stack.min_thickness * (1 - 1e-9));
    REQUIRE(s.size < stack_rules().stack.size);
    REQUIRE(s.point.x < 6000);  // nothing beyond the pinch-out line, and nothing where 24 times the thickness is more
    REQUIRE(s.point.x > 2500);
  }
}

TEST_CASE("the volume between settled horizons is that of the data", "[stack]") {
  const BuiltSurfaces built = build_surfaces(noisy_stack(4), stack_rules());
  REQUIRE(built.stack.settled);
  const double wedge = 0.5 * 5000 * 500 * width;
  CHECK(built.stack.units[0].volume == Approx(wedge).epsilon(0.005));
  CHECK(built.stack.units[1].volume == Approx(800 * width * width - wedge).epsilon(0.005));
}

/// A smooth field of waves 5 to 10 km long, with standard deviation 1 and mean 0.
std::function<double(double, double)> smooth_field(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<std::array<double, 3>> waves(8);
  for (auto& [kx, ky, phase] : waves) {
    const double angle = 2 * std::numbers::pi * uniform(random),
                 k = 2 * std::numbers::pi / (5000 * (1 + uniform(random)));
    kx = k * std::cos(angle), ky = k * std::sin(angle), phase = 2 * std::numbers::pi * uniform(random);
  }
  return [waves](double x, double y) {
    double sum = 0;
    for (const auto& [kx, ky, phase] : waves) sum += std::cos(kx * x + ky * y + phase);
    return 0.5 * sum;
  };
}

/// Volume of a unit of this thickness where it is at least `least` thick, by the midpoint rule.
double volume_of(const std::function<double(double, double)>& thick, double least) {
  constexpr int n = 500;
  const double step = width / n;
  double sum = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      if (const double t = thick(step * (i + 0.5), step * (j + 0.5)); t >= least) sum += t * step * step;
  return sum;
}

TEST_CASE("lenses that are thin against the tolerance keep their volumes in a settled stack", "[stack]") {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const auto relief = smooth_field(seed), sand = smooth_field(100 + seed), coal = smooth_field(200 + seed);
    const double noise = seed % 2 == 0 ? 2 : 0;
    const auto top = [&](double x, double y) { return 150 * relief(x, y); };
    const auto of_sand = [&](double x, double y) { return std::max(0.0, 60 * sand(x, y)); };
    const auto of_coal = [&](double x, double y) { return 50 + 10 * coal(x, y); };
    const auto below = [&](double x, double y) { return top(x, y) - of_sand(x, y); };
    const auto base = [&](double x, double y) { return below(x, y) - of_coal(x, y); };
    const BuiltSurfaces built =
        build_surfaces({grid("top", 111, top, noise, seed), grid("mid", 111, below, noise, 20 + seed),
                        grid("base", 111, base, noise, 40 + seed)},
                       stack_rules());
    REQUIRE(built.stack.settled);
    CAPTURE(seed);
    const auto of_both = [&](double x, double y) { return of_sand(x, y) + of_coal(x, y); };
    const double sand_there = volume_of(of_sand, built.stack.min_thickness);
    CHECK(built.stack.units[0].volume == Approx(sand_there).epsilon(0.005));
    CHECK(built.stack.units[1].volume == Approx(volume_of(of_both, 0) - sand_there).epsilon(0.005));
  }
}

TEST_CASE("no place of a horizon that keeps its place is further from its data than half of the tolerance", "[stack]") {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const auto relief = smooth_field(seed);
    // Coarse and rough data: distances are greatest where edges cross.
    const std::vector<TriangulatedSurface> given{
        grid(
            "top", 45, [&](double x, double y) { return 150 * relief(x, y); }, 4, seed),
        grid(
            "mid", 45, [&](double x, double y) { return 150 * relief(x, y) - thickness(x, y); }, 4, 20 + seed),
        grid(
            "base", 45, [&](double x, double y) { return 150 * relief(x, y) - 800; }, 4, 40 + seed)};
    const BuiltSurfaces built = build_surfaces(given, stack_rules());
    REQUIRE(built.stack.settled);
    const MapLocator data(given[0]), sheet(built.surfaces[0]);
    double most = 0;
    constexpr int n = 1000;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const Vec2 p{width * (i + 0.5) / n, width * (j + 0.5) / n};
        most = std::max(most, std::abs(data.height(p).value() - sheet.height(p).value()));
      }
    CHECK(most <= 10 * (1 + 1e-9));
    CHECK(most > 7);
  }
}

TEST_CASE("an erosive horizon keeps its place and an onlapped one too when a stack is settled", "[stack]") {
  const auto cut = [](double, double) { return -50.0; };
  const auto tilted = [](double x, double) { return -300 + 0.05 * x; };
  const std::vector<TriangulatedSurface> given{grid("top", 111, cut, 1, 1), grid("mid", 111, tilted, 1, 2),
                                               grid("base", 111, lower, 1, 3)};
  ModelRules rules = stack_rules();
  for (const BaseRule base : {BaseRule::erode, BaseRule::onlap}) {
    rules.surfaces.assign(3, SurfaceRules{});
    rules.surfaces[base == BaseRule::erode ? 0 : 1].base = base;
    const BuiltSurfaces built = build_surfaces(given, rules);
    REQUIRE(built.stack.settled);
    const std::size_t keeps = base == BaseRule::erode ? 0 : 1;
    CHECK(built.stack.horizons[keeps].area_moved == 0);
    CHECK(built.stack.horizons[1 - keeps].largest_move == Approx(250).margin(30));
    CHECK(built.stack.units[0].area_merged == Approx(5000 * width).epsilon(0.1));
  }
}

TEST_CASE("a stack is left as given where surfaces are kept exactly, where it is to be kept, and where nothing is thin",
          "[stack]") {
  const std::vector<TriangulatedSurface> noisy = noisy_stack(4);
  ModelRules rules = stack_rules();
  rules.stack.rule = StackRule::keep;
  CHECK(!build_surfaces(noisy, rules).stack.settled);
  rules = stack_rules();
  rules.stack.tolerance = 0;
  CHECK(!build_surfaces(noisy, rules).stack.settled);
  const std::vector<TriangulatedSurface> apart{grid(
                                                   "top", 20, [](double, double) { return 0.0; }, 1, 1),
                                               grid(
                                                   "mid", 20, [](double, double) { return -400.0; }, 1, 2),
                                               grid(
                                                   "base", 20, [](double, double) { return -900.0; }, 1, 3)};
  const BuiltSurfaces built = build_surfaces(apart, stack_rules());
  CHECK(!built.stack.settled);
  CHECK(built.surfaces[1].points == apart[1].points);
}

namespace {

/// Two smooth horizons that cross along x = 5000 at an angle, the younger one erosive, so that a rule says which one
/// cuts.
BuiltSurfaces crossing_at(double degrees, ModelRules rules) {
  const double slope = std::tan(degrees * std::numbers::pi / 180);
  rules.surfaces = {SurfaceRules{}};
  rules.surfaces[0].base = BaseRule::erode;
  const auto level = [](double, double) { return 0.0; };
  const auto dipping = [slope](double x, double) { return slope * (5003.7 - x); };
  const auto deep = [](double, double) { return -2000.0; };
  return build_surfaces({grid("top", 23, level, 0, 1), grid("mid", 23, dipping, 0, 2), grid("base", 23, deep, 0, 3)},
                        rules);
}

}  // namespace

TEST_CASE("horizons that cross at less than two degrees are settled though a rule says which one cuts", "[stack]") {
  for (const double degrees : {0.05, 0.3, 1.0, 1.9}) {
    INFO(degrees << " degrees");
    const BuiltSurfaces built = crossing_at(degrees, stack_rules());
    REQUIRE(built.stack.settled);
    const TriangulatedSurface &top = built.surfaces[0], &mid = built.surfaces[1];
    for (std::size_t v = 0; v < top.points.size(); ++v) REQUIRE(top.points[v].z >= mid.points[v].z);
  }
  for (const double degrees : {2.1, 5.0, 8.0}) {
    INFO(degrees << " degrees");
    CHECK(!crossing_at(degrees, stack_rules()).stack.settled);
  }
}

TEST_CASE("what a settled stack cuts off above the topography is no move", "[stack]") {
  ModelRules rules = stack_rules();
  rules.topography = "top";
  const BuiltSurfaces built = crossing_at(1, rules);
  REQUIRE(built.stack.settled);
  const SettledHorizon& mid = built.stack.horizons[1];
  CHECK(mid.area_above_topography == Approx(0.5 * width * width).epsilon(0.1));
  CHECK(mid.largest_move < 2 * built.stack.min_thickness);
}

TEST_CASE("horizons whose borders lie on the sides of the box are settled in a model with faults", "[stack]") {
  const auto cut = [](std::vector<TriangulatedSurface> given, double from) {
    for (TriangulatedSurface& s : given) {
      for (Vec3& p : s.points) p.x = std::clamp(p.x, from, width), p.y = std::clamp(p.y, 0.0, width);
      std::erase_if(s.triangles, [&](const Triangle& t) { return area_in_map(s, t) == 0; });
    }
    TriangulatedSurface fault;
    fault.name = "fault";
    fault.kind = SurfaceKind::fault;
    fault.points = {{2000, 2000, -3000}, {8000, 2500, -3000}, {8000, 2500, 1000}};
    fault.triangles = {{0, 1, 2}};
    given.push_back(fault);
    return given;
  };
  CHECK(build_surfaces(cut(noisy_stack(4), 0), stack_rules()).stack.settled);
  const BuiltSurfaces ends_inside = build_surfaces(cut(noisy_stack(4), 1000), stack_rules());
  CHECK(!ends_inside.stack.settled);
  REQUIRE(ends_inside.notes.size() == 1);
  CHECK(ends_inside.notes[0].find("ends inside the model") != std::string::npos);
}

TEST_CASE("a stack with an overhanging horizon is left as given, and a note names the horizon", "[stack]") {
  std::vector<TriangulatedSurface> given = noisy_stack(4);
  CHECK(is_single_valued(given[1]));
  given[1].points[111 * 50 + 50].x += 400;
  CHECK(!is_single_valued(given[1]));
  const BuiltSurfaces built = build_surfaces(given, stack_rules());
  CHECK(!built.stack.settled);
  REQUIRE(built.notes.size() == 1);
  CHECK(built.notes[0].find("mid") != std::string::npos);
}

TEST_CASE("pieces of one unit join the largest of them, and what has no name stays", "[stack]") {
  std::vector<ComponentFacts> facts(5);
  for (std::size_t c = 0; c < 5; ++c) facts[c].volume = static_cast<double>(c + 1);
  const std::vector<Index> target = join_targets(facts, {"sand", "", "sand", "shale", ""});
  CHECK(target == std::vector<Index>{2, 1, 2, 3, 4});
  const std::vector<ComponentFacts> joined = joined_facts(facts, target);
  CHECK(joined[0].volume == 4);
  CHECK(joined[2].volume == 4);
  CHECK(joined[1].volume == 2);
}
