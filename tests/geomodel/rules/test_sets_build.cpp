// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/model_rules.hpp"
#include "grid_model.hpp"
#include "naming/sheets.hpp"
#include "naming/sums.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;

namespace {

/// z(x, y) on a grid of n x n cells over [lo, hi]^2, cells left out where `hole(i, j)`.
template <class Z, class Hole>
TriangulatedSurface sheet(const std::string& name, SurfaceKind kind, int n, double lo, double hi, Z&& z, Hole&& hole) {
  TriangulatedSurface s;
  s.name = name;
  s.kind = kind;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = lo + (hi - lo) * i / n, y = lo + (hi - lo) * j / n;
      s.points.push_back({x, y, z(x, y)});
    }
  const auto row = [&](int i, int j) { return static_cast<VertexIndex>(j * (n + 1) + i); };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      if (hole(i, j)) continue;
      s.triangles.push_back({row(i, j), row(i + 1, j), row(i + 1, j + 1)});
      s.triangles.push_back({row(i, j), row(i + 1, j + 1), row(i, j + 1)});
    }
  return s;
}

double map_area(const TriangulatedSurface& s) {
  CompensatedSum sum;
  for (const Triangle& t : s.triangles)
    sum.add(cross(s.points[t[1]] - s.points[t[0]], s.points[t[2]] - s.points[t[0]]).z / 2);
  return sum.value();
}

double area_of(const PolygonSoup& soup, Index surface) {
  double area = 0;
  for (Index f = 0; f < soup.facets.size(); ++f)
    for (Index o = soup.origin_offsets[f]; o < soup.origin_offsets[f + 1]; ++o)
      if (soup.origins[o].surface == surface)
        area += triangle_area(soup.points[soup.facets[f][0]], soup.points[soup.facets[f][1]],
                              soup.points[soup.facets[f][2]]);
  return area;
}

BuiltRows counts(const std::vector<TriangulatedSurface>& surfaces) {
  BuiltRows rows;
  for (const auto& s : surfaces) rows.n_given_triangles.push_back(static_cast<Index>(s.triangles.size()));
  return rows;
}

const Box3 box{{0, 0, 0}, {100, 100, 50}};
const auto no_hole = [](int, int) { return false; };

}  // namespace

TEST_CASE("a tilted sheet goes on in its own plane, flat or at its nearest height until beyond the box", "[sets]") {
  const auto plane_z = [](double x, double y) { return 0.1 * x - 0.05 * y + 20; };
  const TriangulatedSurface given = sheet("h", SurfaceKind::horizon, 6, 20, 80, plane_z, no_hole);
  for (const Extend how : {Extend::flat, Extend::tangent, Extend::nearest}) {
    ModelRules rules;
    rules.box = box;
    rules.surfaces.resize(1);
    rules.surfaces[0].extend = how;
    const BuiltSurfaces built = build_surfaces({given}, rules);
    const TriangulatedSurface& s = built.surfaces[0];
    REQUIRE(s.triangles.size() > given.triangles.size());
    CHECK(built.rows.n_given_triangles[0] == given.triangles.size());
    CHECK(std::equal(given.triangles.begin(), given.triangles.end(), s.triangles.begin()));
    Box3 bounds;
    for (const Vec3& p : s.points) bounds.add(p);
    CHECK((bounds.min.x < 0 && bounds.min.y < 0 && bounds.max.x > 100 && bounds.max.y > 100));
    // No gaps, no overlaps: the map area of all triangles, each facing up, is that of the rectangle.
    CHECK(map_area(s) == Approx((bounds.max.x - bounds.min.x) * (bounds.max.y - bounds.min.y)).epsilon(1e-12));
    for (const Triangle& t : s.triangles)
      CHECK(cross(s.points[t[1]] - s.points[t[0]], s.points[t[2]] - s.points[t[0]]).z > 0);
    for (std::size_t v = given.points.size(); v < s.points.size(); ++v) {
      const Vec3& p = s.points[v];
      if (how == Extend::tangent) CHECK(p.z == Approx(plane_z(p.x, p.y)).epsilon(1e-12));
      if (how == Extend::flat)
        CHECK(p.z == Approx(plane_z(std::clamp(p.x, 20.0, 80.0), std::clamp(p.y, 20.0, 80.0))).epsilon(1e-12));
      if (how == Extend::nearest)
        CHECK(std::any_of(given.points.begin(), given.points.end(), [&](const Vec3& q) { return q.z == p.z; }));
    }
    CHECK(built.notes.size() == 1);
  }
}

TEST_CASE("a steep fault goes on in its mean plane; without a box the rule is refused", "[sets]") {
  TriangulatedSurface fault = sheet(
      "f", SurfaceKind::fault, 4, 40, 60, [](double, double) { return 0.0; }, no_hole);
  for (Vec3& p : fault.points) p = {50 + 0.2 * (p.y - 50), p.x, p.y - 25};  // dips steeply
  ModelRules rules;
  rules.surfaces.resize(1);
  rules.surfaces[0].extend = Extend::flat;
  CHECK_THROWS_AS(build_surfaces({fault}, rules), Error);
  rules.box = box;
  const BuiltSurfaces built = build_surfaces({fault}, rules);
  Box3 bounds;
  for (const Vec3& p : built.surfaces[0].points) {
    bounds.add(p);
    CHECK(p.x == Approx(50 + 0.2 * (p.z - 25)).margin(1e-9));
  }
  CHECK((bounds.min.y < 0 && bounds.max.y > 100 && bounds.min.z < 0 && bounds.max.z > 50));
}

TEST_CASE("holes are filled up to a length of border, larger ones stay and are told", "[sets]") {
  const auto two_holes = [](int i, int j) { return (i == 2 && j == 2) || (i >= 5 && i <= 7 && j >= 5 && j <= 7); };
  const TriangulatedSurface given = sheet(
      "h", SurfaceKind::horizon, 10, 0, 100, [](double, double) { return 7.0; }, two_holes);
  ModelRules rules;
  rules.surfaces.resize(1);
  rules.surfaces[0].fill_holes = 50;
  const BuiltSurfaces some = build_surfaces({given}, rules);
  CHECK(map_area(some.surfaces[0]) == Approx(10000 - 900));
  CHECK(some.notes.size() == 2);
  rules.surfaces[0].fill_holes = std::numeric_limits<double>::infinity();
  CHECK(map_area(build_surfaces({given}, rules).surfaces[0]) == Approx(10000));
}

TEST_CASE("an open body is closed beyond the side of the box that its end is nearest to", "[sets]") {
  // A roof without floor: a pyramid's four sides; the open end is inside the box (drawn out), on its bottom, or beyond.
  for (const double foot : {5.0, 0.0, -5.0}) {
    TriangulatedSurface salt;
    salt.name = "salt";
    salt.kind = SurfaceKind::body;
    salt.points = {{30, 30, foot}, {70, 30, foot}, {70, 70, foot}, {30, 70, foot}, {50, 50, 40}};
    salt.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    ModelRules rules;
    rules.box = box;
    const BuiltSurfaces built = build_surfaces({salt}, rules);
    const TriangulatedSurface& s = built.surfaces[0];
    CHECK(is_closed(s));
    double volume = 0;
    for (const Triangle& t : s.triangles) volume += dot(s.points[t[0]], cross(s.points[t[1]], s.points[t[2]])) / 6;
    const double beyond = 0.05 * norm(box.max - box.min), height = 40 - foot;
    CHECK(volume == Approx(1600 * height / 3 + (foot >= 0 ? 1600 * (foot + beyond) : 0)).epsilon(1e-12));
    REQUIRE(built.notes.size() == 1);
    CHECK(built.notes[0].find("zmin") != std::string::npos);
  }
}

namespace {

/// `upper` dips below `lower` in the left half of a 2 x 1 x 4 grid.
GridModel crossing_horizons() {
  const auto step = [](int left, int right) {
    return [=](const std::array<std::array<int, 3>, 3>& v) {
      const auto all = [&](auto holds) { return std::all_of(v.begin(), v.end(), holds); };
      return all([&](const auto& g) { return g[2] == left && g[0] <= 1; }) ||
             all([&](const auto& g) { return g[2] == right && g[0] >= 1; }) || all([&](const auto& g) {
               return g[0] == 1 && g[2] >= std::min(left, right) && g[2] <= std::max(left, right);
             });
    };
  };
  return make_grid_model({2, 1, 4}, {1, 1, 1},
                         {{"upper", SurfaceKind::horizon, step(1, 3)}, {"lower", SurfaceKind::horizon, step(2, 2)}});
}

}  // namespace

TEST_CASE("erosion, onlap and the rules for crossings cut horizons on the right side", "[sets]") {
  const GridModel grid = crossing_horizons();
  ModelRules rules;
  rules.column = three_layer_rules().column;
  rules.surfaces.resize(2);
  const auto trim = [&] { return trim_soup(grid.soup, grid.surfaces, counts(grid.surfaces), rules); };
  SECTION("conformable: nothing goes") {
    const TrimmedSoup t = trim();
    CHECK(t.notes.empty());
    CHECK(t.soup.facets == grid.soup.facets);
  }
  SECTION("the younger erodes") {
    rules.surfaces[0].base = BaseRule::erode;
    const TrimmedSoup t = trim();
    CHECK(area_of(t.soup, 1) == Approx(1));
    CHECK(area_of(t.soup, 0) == Approx(4));
    CHECK(t.notes.size() == 1);
  }
  SECTION("the younger onlaps the older") {
    rules.surfaces[1].base = BaseRule::onlap;
    const TrimmedSoup t = trim();
    CHECK(area_of(t.soup, 1) == Approx(2));
    CHECK(area_of(t.soup, 0) == Approx(2));
  }
  SECTION("crossings: clip or refuse") {
    rules.on_crossing = OnCrossing::clip_older;
    CHECK(area_of(trim().soup, 1) == Approx(1));
    rules.on_crossing = OnCrossing::clip_younger;
    CHECK(area_of(trim().soup, 0) == Approx(2));
    rules.on_crossing = OnCrossing::error;
    CHECK_THROWS_AS(trim(), Error);
  }
}

TEST_CASE("a piece that does not touch the eroding horizon goes by the vertical through it", "[sets]") {
  const auto left = [](int i, int, int) { return i <= 1; };
  const GridModel grid =
      make_grid_model({2, 1, 4}, {1, 1, 1},
                      {plane("upper", SurfaceKind::horizon, 2, 2), plane("lower", SurfaceKind::horizon, 2, 3, left)});
  ModelRules rules;
  rules.column = three_layer_rules().column;
  rules.surfaces = {{}, {}};
  rules.surfaces[0].base = BaseRule::erode;
  const TrimmedSoup t = trim_soup(grid.soup, grid.surfaces, counts(grid.surfaces), rules);
  CHECK(area_of(t.soup, 1) == 0);
  CHECK(t.soup.points.size() == grid.soup.points.size());  // all of them are on box sides
}

TEST_CASE("a continued fault ends at its target, and short overshoots past a fault go", "[sets]") {
  SECTION("stop_at keeps what was given on both sides") {
    const GridModel grid = make_grid_model(
        {4, 1, 4}, {1, 1, 1}, {plane("f", SurfaceKind::fault, 0, 2), plane("h", SurfaceKind::horizon, 2, 2)});
    ModelRules rules;
    rules.surfaces = {{}, {}};
    rules.surfaces[0].stop_at = "h";
    BuiltRows n_given = counts(grid.surfaces);
    CHECK(trim_soup(grid.soup, grid.surfaces, n_given, rules).notes.empty());
    // Say that only the triangles below h were given: those of the fixture come in the order of their least vertex.
    GridModel part = grid;
    auto& triangles = part.surfaces[0].triangles;
    std::vector<Index> order(triangles.size());
    for (Index t = 0; t < order.size(); ++t) order[t] = t;
    const auto is_high = [&](Index t) {
      double z = 0;
      for (VertexIndex v : triangles[t]) z += part.surfaces[0].points[v].z / 3;
      return z > 2;
    };
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return is_high(a) < is_high(b); });
    std::vector<Index> new_row(order.size());
    for (Index k = 0; k < order.size(); ++k) new_row[order[k]] = k;
    for (auto& o : part.soup.origins)
      if (o.surface == 0) o.triangle = new_row[o.triangle];
    n_given.n_given_triangles[0] = 4;
    const TrimmedSoup t = trim_soup(part.soup, part.surfaces, n_given, rules);
    CHECK(area_of(t.soup, 0) == Approx(2));
    CHECK(t.notes.size() == 1);
    rules.surfaces[0].stop_at = "nowhere";
    CHECK_THROWS_AS(trim_soup(part.soup, part.surfaces, n_given, rules), Error);
  }
  SECTION("overshoot") {
    const GridModel grid =
        make_grid_model({6, 1, 4}, {1, 1, 1},
                        {plane("f", SurfaceKind::fault, 0, 4),
                         plane("h", SurfaceKind::horizon, 2, 2, [](int i, int, int) { return i <= 5; })});
    ModelRules rules;
    rules.trim_overshoot = 0.5;
    CHECK(area_of(trim_soup(grid.soup, grid.surfaces, counts(grid.surfaces), rules).soup, 1) == Approx(5));
    rules.trim_overshoot = 1.5;
    CHECK(area_of(trim_soup(grid.soup, grid.surfaces, counts(grid.surfaces), rules).soup, 1) == Approx(4));
  }
}
