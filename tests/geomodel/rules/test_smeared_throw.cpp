// SPDX-License-Identifier: GPL-3.0-or-later
// Throw restored where a horizon runs across a fault as a ramp.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>

#include "rules/blocks/smeared_throw.hpp"
#include "rules/fault_ends.hpp"
#include "rules/throw/fault_crossings.hpp"
#include "rules/throw/throw_ramp.hpp"

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
  r.rows = restore_smeared_throw(r.made, {{{&fault, 2}, nullptr}}, {}, {r.notes, r.warnings});
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
  std::vector<std::string> notes;
  find_ramps({model.horizon(), model.fault()}, rules, notes);
  CHECK(rules.surfaces[0].throw_at == std::vector<std::string>{"fault"});
  CHECK(notes.size() == 1);
}

namespace {

/// A horizon of 4 by 3 km whose fault, which dips to the east, ends inside at y = 2000. Its throw is an ellipse along
/// the strike, half of it on each side, and dies out away from the fault.
struct Ending {
  double throw_m = 60, spacing = 50, half_width = 2, noise = 0;  // half_width in edges
  static constexpr double tip = 2000, cotangent = 0.5;

  static double level(double x, double y) { return -1000 + 0.03 * (x - 2000) - 0.02 * y; }
  static double across(double x, double y) { return x - 2000 + (level(x, y) + 1000) * cotangent; }
  double throw_at(double y) const { return y >= tip ? 0 : throw_m * std::sqrt(1 - y * y / (tip * tip)); }
  double height(double x, double y, double share) const {
    return level(x, y) - throw_at(y) * 0.5 * share * std::exp(-std::abs(across(x, y)) / 1500);
  }
  TriangulatedSurface horizon() const {
    TriangulatedSurface s{"top", SurfaceKind::horizon, false, false, "", {}, {}};
    std::uint64_t state = 5;
    const auto nx = static_cast<VertexIndex>(4000 / spacing) + 1, ny = static_cast<VertexIndex>(3000 / spacing) + 1;
    for (VertexIndex j = 0; j < ny; ++j)
      for (VertexIndex i = 0; i < nx; ++i) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        const double x = spacing * i, y = spacing * j, r = static_cast<double>(state >> 11) / 9007199254740992.0 - 0.5;
        const double share = std::clamp(across(x, y) / (half_width * spacing), -1.0, 1.0);
        s.points.push_back({x, y, height(x, y, share) + 2 * noise * r});
      }
    for (VertexIndex j = 0; j + 1 < ny; ++j)
      for (VertexIndex i = 0; i + 1 < nx; ++i) {
        const VertexIndex a = j * nx + i;
        s.triangles.push_back({a, a + 1, a + nx + 1});
        s.triangles.push_back({a, a + nx + 1, a + nx});
      }
    return s;
  }
  static TriangulatedSurface fault() {
    TriangulatedSurface s{"fault", SurfaceKind::fault, false, false, "", {}, {}};
    const double off = 1000 * cotangent;
    s.points = {{2000 - off, -500, 0}, {2000 - off, tip, 0}, {2000 + off, tip, -2000}, {2000 + off, -500, -2000}};
    s.triangles = {{0, 1, 2}, {0, 2, 3}};
    return s;
  }
};

/// The throw restored is the true one up to six edges from the end, within `share`; both sheets have the same
/// nodes beyond its end.
void check_ending(const Ending& model, double share) {
  INFO("throw " << model.throw_m << ", edges " << model.spacing << ", noise " << model.noise);
  const TriangulatedSurface given = model.horizon();
  TriangulatedSurface made = given, fault = Ending::fault();
  const Box3 box{{100, 100, -2000}, {3900, 2900, 0}};
  const Index first = continue_fault(fault, box, box);
  REQUIRE(first < fault.triangles.size());
  std::vector<std::string> notes, warnings;
  const RestoredThrow rows = restore_smeared_throw(made, {{{&fault, first}, nullptr}}, {}, {notes, warnings});
  CHECK(warnings.empty());
  REQUIRE(rows.sheet.size() == made.triangles.size());
  CHECK(std::set<Index>(rows.sheet.begin(), rows.sheet.end()).size() == 3);
  std::map<std::pair<double, double>, std::set<double>> heights;  // of all sheets, by place
  for (Index t = 0; t < rows.sheet.size(); ++t)
    for (const VertexIndex v : made.triangles[t])
      heights[{made.points[v].x, made.points[v].y}].insert(made.points[v].z);
  std::size_t n = 0;
  for (const auto& [place, at] : heights) {
    const auto& [x, y] = place;
    if (y > Ending::tip + 3 * model.spacing) CHECK(at.size() == 1);
    if (std::abs(Ending::across(x, y)) > model.spacing || y > Ending::tip - 6 * model.spacing) continue;
    REQUIRE(at.size() == 2);
    CHECK(*at.rbegin() - *at.begin() == Approx(model.throw_at(y)).margin(share * model.throw_m));
    ++n;
  }
  CHECK(static_cast<double>(n) > 0.6 * Ending::tip / model.spacing);
  for (Index t = 0; t < rows.sheet.size(); ++t)
    if (rows.sheet[t] == BuiltRows::of_every_block) CHECK(t < rows.n_given);
}

}  // namespace

TEST_CASE("throw that is smeared across a fault that ends inside is restored, and dies out at its end",
          "[smeared_throw]") {
  for (const double throw_m : {40.0, 80.0})
    for (const double spacing : {25.0, 50.0, 100.0}) {
      const double share = spacing < 100 ? 0.05 : 0.07;  // of which most is drag within the ramp
      check_ending({throw_m, spacing}, share);
      check_ending({throw_m, spacing, 1.5, 0.5}, share + 0.02);
    }
}

TEST_CASE("a horizon whose sides tell another throw than its ramp keeps it, with a warning", "[smeared_throw]") {
  const Faulted model{60, 100};
  TriangulatedSurface made = model.horizon();
  const TriangulatedSurface fault = model.fault();
  // The eastern side rises steeply from the foot of the ramp.
  for (Vec3& p : made.points) {
    const double d = model.across(p.x, p.y);
    if (d > 150) p.z += std::min(300.0, 1.2 * (d - 150));
  }
  std::vector<std::string> notes, warnings;
  const TriangulatedSurface before = made;
  const RestoredThrow rows = restore_smeared_throw(made, {{{&fault, 2}, nullptr}}, {}, {notes, warnings});
  CHECK(rows.sheet.empty());
  CHECK((made.triangles == before.triangles));
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find("is not restored, and the ramps are kept: what lies beside it gives a throw of") !=
        std::string::npos);
}

TEST_CASE("A ramp is as wide as the widest of a stretch and its neighbours, else as the nearest stretch",
          "[smeared_throw]") {
  Ramp ramp;
  ramp.at = {{3, {1, 4}}, {4, {2, 2}}, {10, {5, 1}}};
  const auto is = [&](long stretch, double below, double above) {
    const RampWidth width = ramp.width(stretch);
    CHECK(width.below == below);
    CHECK(width.above == above);
  };
  is(2, 1, 4);
  is(3, 2, 4);
  is(4, 2, 4);
  is(5, 2, 2);
  is(6, 2, 2);  // beyond the neighbours
  is(8, 5, 1);
  is(11, 5, 1);
  is(-100, 1, 4);
}
