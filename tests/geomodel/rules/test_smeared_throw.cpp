// SPDX-License-Identifier: GPL-3.0-or-later
// Throw restored where a horizon runs across a fault as a ramp.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>

#include "rules/smeared_throw.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

constexpr double spacing = 50;
constexpr VertexIndex n_x = 81, n_y = 61;

/// A horizon of 4 by 3 km with throw across a fault in its middle that strikes along y.
struct Faulted {
  double throw_m = 60, half_width = 100, dip_degrees = 60;
  double slope = 0.05, relief = 0, noise = 0;
  bool is_torn = false;  ///< nodes of the ramp are undefined

  double level(double x, double y) const {
    return -1000 + slope * (x - 2000) - 0.03 * y + relief * std::sin(x / 900) * std::cos(y / 1100);
  }
  double cotangent() const { return 1 / std::tan(dip_degrees * 3.14159265358979 / 180); }
  /// From the fault at the level of the footwall, positive on the hanging wall.
  double across(double x, double y) const { return x - 2000 + (level(x, y) + 1000) * cotangent(); }

  TriangulatedSurface horizon() const {
    TriangulatedSurface s{"top", SurfaceKind::horizon, false, false, "", {}, {}};
    std::uint64_t state = 11;
    std::vector<bool> is_there;
    for (VertexIndex j = 0; j < n_y; ++j)
      for (VertexIndex i = 0; i < n_x; ++i) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        const double x = spacing * i, y = spacing * j, r = static_cast<double>(state >> 11) / 9007199254740992.0 - 0.5;
        const double share = 0.5 + 0.5 * std::clamp(across(x, y) / half_width, -1.0, 1.0);
        s.points.push_back({x, y, level(x, y) - throw_m * share + 2 * noise * r});
        is_there.push_back(!is_torn || std::abs(across(x, y)) > half_width);
      }
    const auto add = [&](Triangle t) {
      if (is_there[t[0]] && is_there[t[1]] && is_there[t[2]]) s.triangles.push_back(t);
    };
    for (VertexIndex j = 0; j + 1 < n_y; ++j)
      for (VertexIndex i = 0; i + 1 < n_x; ++i) {
        const VertexIndex a = j * n_x + i;
        add({a, a + 1, a + n_x + 1});
        add({a, a + n_x + 1, a + n_x});
      }
    return s;
  }
  TriangulatedSurface fault(double at = 2000) const {
    TriangulatedSurface s{"fault", SurfaceKind::fault, false, false, "", {}, {}};
    const double off = 1000 * cotangent();
    s.points = {{at - off, -100, 0}, {at - off, 3100, 0}, {at + off, 3100, -2000}, {at + off, -100, -2000}};
    s.triangles = {{0, 1, 2}, {0, 2, 3}};
    return s;
  }
};

struct Restored {
  TriangulatedSurface given, made;
  RestoredThrow rows;
  std::vector<std::string> notes, warnings;
};

Restored restore(const Faulted& model, double fault_at = 2000) {
  Restored r;
  r.given = r.made = model.horizon();
  const TriangulatedSurface fault = model.fault(fault_at);
  r.rows = restore_smeared_throw(r.made, {&fault}, {}, {r.notes, r.warnings});
  return r;
}

/// The two sides reach the fault at their own level, within `share` of the throw, and nothing else has changed.
void check_restored(const Faulted& model, double share) {
  INFO("throw " << model.throw_m << ", half width " << model.half_width << ", dip " << model.dip_degrees << ", relief "
                << model.relief);
  const Restored r = restore(model);
  REQUIRE(r.rows.sheet.size() == r.made.triangles.size());
  CHECK(std::set<Index>(r.rows.sheet.begin(), r.rows.sheet.end()).size() == 2);
  for (VertexIndex v = 0; v < r.given.points.size(); ++v) REQUIRE(r.made.points[v] == r.given.points[v]);
  const std::set<Triangle> given(r.given.triangles.begin(), r.given.triangles.end());
  for (Index t = 0; t < r.rows.n_given; ++t) REQUIRE(given.contains(r.made.triangles[t]));
  const std::set<Triangle> kept(r.made.triangles.begin(), r.made.triangles.begin() + r.rows.n_given);
  double furthest = 0;
  for (const Triangle& t : r.given.triangles)
    for (const VertexIndex v : t)
      if (!kept.contains(t))
        furthest = std::max(furthest, std::abs(model.across(r.given.points[v].x, r.given.points[v].y)));
  CHECK(furthest < model.half_width + std::abs(model.throw_m) * model.cotangent() + 4 * spacing);
  double worst_height = 0, worst_throw = 0;
  std::map<std::pair<double, double>, double> low, high;  // by place at the fault
  for (Index t = r.rows.n_given; t < r.made.triangles.size(); ++t)
    for (const VertexIndex v : r.made.triangles[t]) {
      const Vec3& p = r.made.points[v];
      if (std::abs(model.across(p.x, p.y)) > 1.5 * spacing) continue;
      const bool is_low = r.rows.sheet[t] == r.rows.sheet[r.rows.n_given - 1];
      const double off = p.z - model.level(p.x, p.y) + (is_low ? model.throw_m : 0);
      worst_height = std::max(worst_height, std::abs(off));
      (is_low ? low : high)[{p.x, p.y}] = off;
    }
  CHECK(low.size() >= n_y);
  CHECK(high.size() >= n_y);
  for (const auto& [place, off] : low)
    if (high.contains(place)) worst_throw = std::max(worst_throw, std::abs(off - high.at(place)));
  CHECK(worst_throw <= share * std::abs(model.throw_m));
  CHECK(worst_height <= 2 * share * std::abs(model.throw_m));
  REQUIRE(r.notes.size() == 2);
  CHECK(r.notes[0].find("throw smeared across fault over") != std::string::npos);
  CHECK(r.warnings.empty());
}

}  // namespace

TEST_CASE("a ramp across a fault becomes a step of the true throw", "[smeared_throw]") {
  for (const double throw_m : {30.0, 60.0, -80.0})
    for (const double half_width : {60.0, 100.0, 200.0})
      for (const double dip : {45.0, 60.0, 88.0}) check_restored({throw_m, half_width, dip}, 0.001);
}

TEST_CASE("throw of curved and noisy horizons is restored within a few per cent", "[smeared_throw]") {
  for (const double throw_m : {60.0, 120.0})
    for (const double half_width : {60.0, 120.0}) {
      check_restored({throw_m, half_width, 60, 0.05, 40}, 0.05);
      check_restored({throw_m, half_width, 60, 0.05, 0, 1}, 0.05);
    }
}

TEST_CASE("slopes that are no ramp along the fault stay", "[smeared_throw]") {
  CHECK(restore({0, 100}).rows.sheet.empty());                         // no throw
  CHECK(restore({0, 100, 60, 0.3}).rows.sheet.empty());                // steep
  CHECK(restore({0, 100, 60, 0.05, 40}).rows.sheet.empty());           // curved
  CHECK(restore({0, 100, 60, 0.05, 0, 3}).rows.sheet.empty());         // noisy
  CHECK(restore({80, 200}, 900).rows.sheet.empty());                   // a flexure away from the fault
  CHECK(restore({80, 1000}).rows.sheet.empty());                       // a flexure much wider than a ramp
  CHECK(restore({60, 100, 60, 0.05, 0, 0, true}).rows.sheet.empty());  // torn already
}

TEST_CASE("a ramp tells that a fault displaces a horizon", "[smeared_throw][throw_auto]") {
  const Faulted model{60, 150};
  ModelRules rules;
  rules.surfaces.resize(2);
  rules.surfaces[0].throw_auto = true;
  std::vector<std::string> notes, warnings;
  find_throws({model.horizon(), model.fault()}, rules, notes, warnings);
  CHECK(rules.surfaces[0].throw_at == std::vector<std::string>{"fault"});
  CHECK(warnings.empty());
}
