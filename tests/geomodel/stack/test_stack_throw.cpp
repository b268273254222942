// SPDX-License-Identifier: GPL-3.0-or-later
// Stacks of horizons with throw: settled, and in order on both sides of their faults.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/throw/nearest_point.hpp"
#include "rules/throw/side_bounds.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

constexpr double width = 6000;

/// Three horizons with 30 m of throw, smeared over 150 m; the unit between the first two is there west of x = 3000.
struct FaultedStack {
  double at = 2000;        ///< of the fault, which strikes along y and dips by 60 degrees
  double end = 2 * width;  ///< of the fault in y, at which its throw is nought
  bool is_torn = false;
  std::vector<bool> has_throw{true, true, true};

  double across(double x, double z) const { return x - at + (z + 500) / std::tan(std::numbers::pi / 3); }
  double throw_at(double y) const { return 30 * std::sqrt(std::max(0.0, 1 - std::pow(y / end, 2))); }

  TriangulatedSurface grid(std::size_t k, unsigned seed) const {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-0.5, 0.5);
    TriangulatedSurface s;
    s.name = std::vector<std::string>{"top", "mid", "base"}[k];
    s.kind = SurfaceKind::horizon;
    constexpr int n = 141;
    std::vector<bool> is_there;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const double x = -500 + 50 * i, y = -500 + 50 * j, sand = std::max(0.0, 0.02 * (3000 - x));
        const double z = -450 + 30 * std::sin(x / 1500) * std::cos(y / 2000) - (k > 0 ? sand : 0) - (k > 1 ? 80 : 0);
        const double d = across(x, z);
        is_there.push_back(!is_torn || !has_throw[k] || std::abs(d) > 80);
        s.points.push_back(
            {x, y, z + uniform(random) - (has_throw[k] ? throw_at(y) : 0) * 0.5 * std::clamp(d / 75, -1.0, 1.0)});
      }
    for (int j = 0; j + 1 < n; ++j)
      for (int i = 0; i + 1 < n; ++i) {
        const auto a = static_cast<VertexIndex>(j * n + i), c = a + static_cast<VertexIndex>(n);
        for (const Triangle& t : {Triangle{a, a + 1, c + 1}, Triangle{a, c + 1, c}})
          if (is_there[t[0]] && is_there[t[1]] && is_there[t[2]]) s.triangles.push_back(t);
      }
    return s;
  }

  std::vector<TriangulatedSurface> surfaces() const {
    TriangulatedSurface fault;
    fault.name = "fault";
    fault.kind = SurfaceKind::fault;
    const double off = 1000 / std::tan(std::numbers::pi / 3);
    fault.points = {{at - off, -600, 500}, {at - off, end, 500}, {at + off, end, -1500}, {at + off, -600, -1500}};
    fault.triangles = {{0, 1, 2}, {0, 2, 3}};
    return {grid(0, 1), grid(1, 2), grid(2, 3), fault};
  }

  ModelRules rules() const {
    ModelRules rules;
    rules.column = {"air", "top", "sand", "mid", "shale", "base", "basement"};
    rules.box = Box3{{0, 0, -1400}, {width, width, 400}};
    rules.min_thickness = 5;
    rules.surfaces.resize(4);
    for (std::size_t k = 0; k < 3; ++k)
      if (has_throw[k]) rules.surfaces[k].throw_at = {"fault"};
    rules.stack.size = 400;
    rules.stack.tolerance = 6;
    rules.stack.outline = {{0, 0}, {width, 0}, {width, width}, {0, width}};
    rules.stack.outline_is_box = true;
    return rules;
  }
};

/// Heights over places of the map, by whether the block lies above the fault.
using Heights = std::map<std::pair<double, double>, double>;
Heights heights_of(const BuiltSurfaces& built, std::size_t k, bool above) {
  const std::vector<Index>& block_of = built.rows.block_of_triangle[k];
  Heights heights;
  for (std::size_t t = 0; t < built.surfaces[k].triangles.size(); ++t) {
    const bool is_of_all = block_of.empty() || block_of[t] == BuiltRows::of_every_block;
    if (!is_of_all) REQUIRE(block_of[t] < built.rows.sides_of_block[k].size());
    if (!is_of_all && built.rows.sides_of_block[k][block_of[t]][0] != above) continue;
    for (const VertexIndex v : built.surfaces[k].triangles[t]) {
      const Vec3& p = built.surfaces[k].points[v];
      const auto [at, is_new] = heights.emplace(std::pair(p.x, p.y), p.z);
      REQUIRE(at->second == p.z);
    }
  }
  return heights;
}

/// On each side horizons are in order over the same places, share heights east of x = 3000, and follow the data.
void check_sides(const FaultedStack& model) {
  const BuiltSurfaces built = build_surfaces(model.surfaces(), model.rules());
  std::string notes;
  for (const std::string& note : built.notes) notes += note + "\n";
  for (const std::string& warning : built.warnings) notes += warning + "\n";
  INFO(notes);
  REQUIRE(built.stack.settled);
  for (const bool above : {false, true}) {
    std::vector<Heights> heights;
    for (std::size_t k = 0; k < 3; ++k) heights.push_back(heights_of(built, k, above));
    INFO(heights[0].size() << ", " << heights[1].size() << ", " << heights[2].size() << " places");
    std::size_t n_both = 0, n_shared = 0;
    for (std::size_t k = 0; k < 2; ++k)
      for (const auto& [place, z] : heights[k]) {
        const auto below = heights[k + 1].find(place);
        if (below == heights[k + 1].end()) continue;
        ++n_both;
        REQUIRE(z >= below->second);
        if (k == 1) continue;
        if (place.first > 3400) CHECK(z == below->second);
        if (place.first < 2400) CHECK(z - below->second >= 5 - 1e-9);
        n_shared += z == below->second;
      }
    CHECK(n_both > 100);
    if (above) CHECK(n_shared > 50);
  }
}

}  // namespace

TEST_CASE("horizons with throw are settled in order on both sides of their fault", "[stack][throw]") {
  for (const double at : {1200.0, 2000.0, 3000.0, 4500.0})
    for (const bool is_torn : {false, true}) {
      FaultedStack model{at};
      model.is_torn = is_torn;
      INFO("fault at " << at << (is_torn ? ", torn" : ""));
      check_sides(model);
    }
}

TEST_CASE("throw is there on both sides of a fault in a settled stack, and not beyond its end", "[stack][throw]") {
  for (const double end : {2 * width, 3000.0}) {
    FaultedStack model{2000};
    model.end = end;
    check_sides(model);
    const BuiltSurfaces built = build_surfaces(model.surfaces(), model.rules());
    const Heights low = heights_of(built, 2, false), high = heights_of(built, 2, true);
    std::size_t n = 0;
    for (const auto& [place, z] : low) {
      const auto over = high.find(place);
      if (over == high.end() || place.second < 0) continue;
      ++n;
      // Within the size of the end the throw is that of triangles as long.
      const double due = place.second > end ? 0 : model.throw_at(place.second);
      CHECK(z - over->second == Approx(due).margin(std::abs(place.second - end) < 800 ? 16 : 3));
    }
    CHECK(n > 10);
  }
}

TEST_CASE("a horizon without throw keeps its one height among those with it", "[stack][throw]") {
  for (const std::size_t whole : {0, 2}) {
    FaultedStack model{1500};
    model.has_throw[whole] = false;
    const BuiltSurfaces built = build_surfaces(model.surfaces(), model.rules());
    REQUIRE(built.stack.settled);
    CHECK(built.rows.block_of_triangle[whole].empty());
    for (const bool above : {false, true})
      for (std::size_t k = 0; k < 2; ++k) {
        const Heights upper = heights_of(built, k, above), lower = heights_of(built, k + 1, above);
        for (const auto& [place, z] : upper)
          if (const auto below = lower.find(place); below != lower.end()) REQUIRE(z >= below->second);
      }
  }
}

TEST_CASE("the nearest of points is found as by looking at all", "[throw]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Vec3> points;
  for (int k = 0; k < 500; ++k) {
    const double x = std::floor(8 * uniform(random)), y = uniform(random);
    points.push_back({x, y, 0.3 * x});
  }
  const NearestPoint nearest(points);
  const auto distance = [](const Vec3& p, const Vec3& q) { return dot(p - q, p - q); };
  for (int k = 0; k < 500; ++k) {
    const double x = 30 * uniform(random) - 10, y = 6 * uniform(random) - 3;
    const Vec3 p{x, y, 10 * uniform(random)};
    const Index found = nearest.find(p);
    for (const Vec3& q : points) REQUIRE(distance(p, points[found]) <= distance(p, q) * (1 + 1e-12));
  }
  CHECK(NearestPoint({}).find({0, 0, 0}) == no_index);
}

TEST_CASE("a place is on one side of many planes only where each of them says so", "[throw]") {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<SidedPlane> planes;
  for (int k = 0; k < 400; ++k) {
    const double x = 10 * uniform(random), y = 10 * uniform(random);
    planes.push_back({{x, y, 0.01 * x * x}, {-0.02 * x + 0.05 * uniform(random), 0.05 * uniform(random), 1}});
  }
  const SideBounds bounds(planes);
  std::size_t n_above = 0, n_below = 0, n_open = 0;
  for (int k = 0; k < 2000; ++k) {
    const Vec3 p{20 * uniform(random), 20 * uniform(random), 8 * uniform(random)};
    const SideOfAll side = bounds.side(p);
    n_above += side == SideOfAll::above, n_below += side == SideOfAll::below, n_open += side == SideOfAll::not_known;
    for (const SidedPlane& plane : planes) {
      if (side == SideOfAll::above) REQUIRE(dot(p - plane.point, plane.normal) > 0);
      if (side == SideOfAll::below) REQUIRE(dot(p - plane.point, plane.normal) < 0);
    }
  }
  CHECK((n_above > 200 && n_below > 200 && n_open > 100));
  planes.push_back({{0, 0, 0}, {0, 0, 0}});
  CHECK(SideBounds(planes).side({0, 0, 100}) == SideOfAll::not_known);
  CHECK(SideBounds({}).side({0, 0, 1}) == SideOfAll::not_known);
}
