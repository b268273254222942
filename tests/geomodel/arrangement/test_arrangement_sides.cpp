// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces on the sides of a volume that is no box along the axes, but for rounding or for a tolerance.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "arrangement/model/ingest.hpp"
#include "arrangement/sides/join_to_sides.hpp"
#include "arrangement_inputs.hpp"
#include "common_edges.hpp"
#include "dice.hpp"
#include "geomesh/geomodel/model_volume.hpp"
#include "require_sound.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;

namespace {

constexpr double pi = 3.14159265358979323846, step = 50;
constexpr unsigned n = 12;                     // cells a row inside the volume
constexpr double width = n * step, top = 300;  // of the volume, from 0 on

/// A frame in the map, turned about its first corner.
struct Turned {
  double degrees, east, north;
  Vec3 place(double x, double y, double z) const {
    const double c = std::cos(degrees * pi / 180), s = std::sin(degrees * pi / 180);
    return {east + c * x - s * y, north + s * x + c * y, z};
  }
};

/// A square with its first corner in the frame's; sides are computed apart from the grid.
std::vector<TriangulatedSurface> sides_of(const Turned& frame) {
  VolumeSpec spec;
  spec.shape = VolumeSpec::Shape::turned;
  const Vec3 middle = frame.place(width / 2, width / 2, 0);
  spec.center = {middle.x, middle.y};
  spec.size = {width, width};
  spec.azimuth = -frame.degrees;
  spec.bottom = 0;
  spec.top = top;
  return make_volume(spec, {}, {}).sides;
}

/// A horizon on a grid whose rows are the sides, and that goes on over `beyond` cells.
TriangulatedSurface horizon(const Turned& frame, unsigned beyond) {
  const double low = -step * beyond, high = width + step * beyond;
  auto grid = grid_surface("h", SurfaceKind::horizon, n + 2 * beyond, low, high, low, high,
                           [](double x, double y) { return 150 + 40 * std::sin(x / 90) * std::cos(y / 70); });
  for (Vec3& p : grid.points) p = frame.place(step * std::round(p.x / step), step * std::round(p.y / step), p.z);
  return grid;
}

double least_height(const PolygonSoup& soup) {
  double least = 1e300;
  for (const Triangle& t : soup.facets) {
    const Vec3 &a = soup.points[t[0]], &b = soup.points[t[1]], &c = soup.points[t[2]];
    const double longest =
        std::max({arrangement::length(b - a), arrangement::length(c - b), arrangement::length(a - c)});
    least = std::min(least, 2 * arrangement::area(a, b, c) / longest);
  }
  return least;
}

/// Of a volume in a frame that the seed turns and places.
struct Case {
  Dice dice;
  Turned frame;
  ArrangementOptions options;

  Case(unsigned seed, double tolerance) : dice(seed) {
    take_frame({dice.between(-90, 90), dice.between(0, 5e5), dice.between(0, 6e6)});
    options.tolerance = tolerance;
  }
  void take_frame(const Turned& turned) {
    frame = turned;
    options.volume = sides_of(frame);
  }
  ArrangementResult arrange(const TriangulatedSurface& surface) const { return arrange_all({surface}); }
  ArrangementResult arrange_all(const std::vector<TriangulatedSurface>& surfaces) const {
    ArrangementResult result = geomodel::arrange(surfaces, {}, {}, options);
    require_sound(result.soup);
    return result;
  }
  /// The same volume as a box, where the frame is not turned.
  void take_box() {
    frame.degrees = 0;
    options.volume.clear();
    const Vec3 far = frame.place(width, width, top);
    options.box = Box3{{frame.east, frame.north, 0}, far};
  }
  /// In the map, of edges that the surface shares with sides.
  double length_on_sides(const PolygonSoup& soup) const {
    double sum = 0;
    for (Index side = 1; side <= options.volume.size(); ++side)
      for (const auto& [a, b] : common_edges(soup, 0, side))
        sum += std::hypot(soup.points[a].x - soup.points[b].x, soup.points[a].y - soup.points[b].y);
    return sum;
  }
};

/// Of edges that the surface shares with two sides.
double length_on_creases(const PolygonSoup& soup, Index surface, Index first_side, Index n_sides) {
  std::map<std::pair<VertexIndex, VertexIndex>, unsigned> n_sides_at;
  for (Index side = first_side; side < first_side + n_sides; ++side)
    for (const auto& e : common_edges(soup, surface, side)) ++n_sides_at[e];
  double sum = 0;
  for (const auto& [e, n_at] : n_sides_at)
    if (n_at > 1) sum += arrangement::length(soup.points[e.first] - soup.points[e.second]);
  return sum;
}

/// Upright, through the first corner of the volume but for `off`, at an angle to the side that is south there. It
/// begins before the corner and ends above and below the volume.
TriangulatedSurface fault_by_corner(const Turned& frame, double degrees, double off, unsigned cells) {
  const double c = std::cos(degrees * pi / 180), s = std::sin(degrees * pi / 180);
  TriangulatedSurface fault = grid_surface("f", SurfaceKind::fault, cells, -0.1 * width, 0.8 * width, -20, top + 20,
                                           [](double, double) { return 0; });
  for (Vec3& p : fault.points) p = frame.place(p.x * c - off * s, p.x * s + off * c, p.y);
  return fault;
}

/// A square of which doubles lie on the sides, turned by 45 degrees.
std::vector<TriangulatedSurface> sides_of_diamond() {
  VolumeSpec spec;
  spec.shape = VolumeSpec::Shape::polygon;
  spec.polygon = {{0, 0}, {8, 8}, {0, 16}, {-8, 8}};
  spec.bottom = 0;
  spec.top = 8;
  return make_volume(spec, {}, {}).sides;
}

}  // namespace

TEST_CASE("sides: rows of a grid along a turned side are on it", "[arrangement]") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    INFO("seed " << seed);
    const Case c(seed, seed % 2 == 0 ? 0 : 0.5);
    const auto result = c.arrange(horizon(c.frame, seed % 3));
    CHECK(least_height(result.soup) > 1);
    CHECK(c.length_on_sides(result.soup) == Approx(4 * width).epsilon(1e-9));
    CHECK(result.merging.displacement.largest < 2 * 32 * 0x1p-30);
  }
}

TEST_CASE("sides: ends nearer than the tolerance go to a turned side, others stay", "[arrangement]") {
  for (unsigned seed = 0; seed < 40; ++seed) {
    INFO("seed " << seed);
    const Case c(seed, 0.5);
    const bool is_near = seed % 2 == 0;
    const double off = is_near ? 0.01 : 2;
    const auto inwards = [&](double x) { return x < 1 ? x + off : x > width - 1 ? x - off : x; };
    TriangulatedSurface given = grid_surface("h", SurfaceKind::horizon, n, 0, width, 0, width,
                                             [](double x, double y) { return 150 + 0.1 * x - 0.05 * y; });
    for (Vec3& p : given.points) p = c.frame.place(inwards(p.x), inwards(p.y), p.z);
    const auto result = c.arrange(given);
    CHECK(c.length_on_sides(result.soup) == Approx(is_near ? 4 * width : 0).epsilon(1e-9));
    if (is_near) CHECK(least_height(result.soup) > 1);
  }
}

TEST_CASE("sides: a fault that ends beside a side reaches it, with corners beyond the volume", "[arrangement]") {
  for (unsigned seed = 0; seed < 40; ++seed) {
    INFO("seed " << seed);
    Case c(seed, 0.5);
    Dice& dice = c.dice;
    const double x = dice.between(0.3, 0.7) * width, dip = dice.between(-100, 100), off = dice.between(-0.02, 0.02);
    TriangulatedSurface fault;
    fault.name = "f";
    fault.kind = SurfaceKind::fault;
    fault.triangles = {{0, 1, 2}, {0, 2, 3}};
    for (const double y : {off, width - off}) {
      fault.points.push_back(c.frame.place(x + (y < 1 ? -dip : dip), y, y < 1 ? -80 : top + 80));
      fault.points.push_back(c.frame.place(x + (y < 1 ? dip : -dip), y, y < 1 ? top + 80 : -80));
    }
    const auto result = c.arrange(fault);
    for (const auto& spot : result.spots) CHECK(spot.what != "free border");
    const double on_sides = c.length_on_sides(result.soup);
    const double slope = 2 * dip / (top + 160);
    CHECK(on_sides == Approx(2 * width + 2 * std::fabs(slope) * top).epsilon(1e-3));
  }
}

TEST_CASE("sides: what lies on a side exactly, or crosses it plainly, is left to the intersection", "[arrangement]") {
  const auto sides = sides_of_diamond();
  const auto floor = triangles(
      "floor", {{Vec3{2, 2, 3}, Vec3{6, 6, 3}, Vec3{0, 8, 3}}, {Vec3{6, 6, 3}, Vec3{2, 2, 3}, Vec3{6, 1, 3}}});
  const std::vector<TriangulatedSurface> given{floor};
  auto ingested = arrangement::ingest({given, sides}, {}, {}, std::nullopt);
  std::vector<VertexIndex> now;
  CHECK_FALSE(arrangement::join_to_sides(ingested.complex, {32 * 0x1p-49, std::nullopt, 1, true}, now));
  CHECK_FALSE(arrangement::move_to_sides(ingested.complex, {32 * 0x1p-49, std::nullopt, 1, true}, 0.5).points_moved);
}

TEST_CASE("sides: an end stays where a triangle would turn over", "[arrangement]") {
  const auto sides = sides_of_diamond();
  // Ends 0.1 beyond the side, with a corner 0.05 beyond it.
  const Vec3 along{std::sqrt(0.5), std::sqrt(0.5), 0}, outwards{std::sqrt(0.5), -std::sqrt(0.5), 0}, z{0, 0, 3};
  const std::vector<TriangulatedSurface> given{triangles(
      "floor",
      {{z + 4 * along + 0.1 * outwards, z + 4.2 * along + 0.1 * outwards, z + 4.1 * along + 0.05 * outwards}})};
  auto ingested = arrangement::ingest({given, sides}, {}, {}, std::nullopt);
  const auto before = ingested.complex.points;
  arrangement::move_to_sides(ingested.complex, {32 * 0x1p-49, std::nullopt, 1, true}, 0.5);
  CHECK(ingested.complex.points == before);
}

TEST_CASE("sides: a fault that passes beside an upright edge is drawn to it", "[arrangement]") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    INFO("seed " << seed);
    Case c(seed, 0.5);
    if (seed % 3 == 0) c.take_box();
    if (seed % 3 == 1) c.take_frame({45, 0, 0});  // of which the upright edges have doubles on them
    c.options.merging = ArrangementOptions::MergingOf::surfaces_that_meet;
    const double off = seed % 6 == 4 ? 0 : (seed % 2 == 0 ? 1 : -1) * std::pow(10, c.dice.between(-9, -0.5));
    const auto fault = fault_by_corner(c.frame, c.dice.between(20, 70), off, 1 + seed % 7);
    const auto result = c.arrange_all({horizon(c.frame, seed % 2), fault});
    CHECK(length_on_creases(result.soup, 1, 2, 6) == Approx(top).epsilon(1e-9));
    // In a box the end inside joins the side's own edges, too.
    if (!c.options.box) CHECK(c.arrange(fault).merging.displacement.largest <= std::fabs(off) + 1e-6);
    for (const auto& spot : result.spots) CHECK(spot.what != "self-crossing");
  }
}

TEST_CASE("sides: a fault farther from an upright edge than the tolerance stays", "[arrangement]") {
  for (unsigned seed = 0; seed < 12; ++seed) {
    INFO("seed " << seed);
    Case c(seed, 0.5);
    if (seed % 3 == 0) c.take_box();
    c.options.merging = ArrangementOptions::MergingOf::surfaces_that_meet;
    const auto result = c.arrange(fault_by_corner(c.frame, 45, 2, 1 + seed % 4));
    CHECK(length_on_creases(result.soup, 0, 1, 6) == 0);
    if (!c.options.box) CHECK(result.merging.displacement.largest < 1e-6);
  }
}

TEST_CASE("sides: facets on an upright edge exactly are left to the intersection", "[arrangement]") {
  const auto sides = sides_of_diamond();
  const std::vector<TriangulatedSurface> given{triangles(
      "f", {{Vec3{0, -8, -2}, Vec3{0, 18, -2}, Vec3{0, 18, 10}}, {Vec3{0, -8, -2}, Vec3{0, 18, 10}, Vec3{0, -8, 10}}})};
  auto ingested = arrangement::ingest({given, sides}, {}, {}, std::nullopt);
  const auto before = ingested.complex.points;
  CHECK_FALSE(arrangement::draw_to_feature_edges(ingested.complex, {32 * 0x1p-49, std::nullopt, 1, true}, 0.5));
  CHECK(ingested.complex.points == before);
  auto beside = given;
  for (Vec3& p : beside[0].points) p.x = 0x1p-10;
  auto other = arrangement::ingest({beside, sides}, {}, {}, std::nullopt);
  CHECK(arrangement::draw_to_feature_edges(other.complex, {32 * 0x1p-49, std::nullopt, 1, true}, 0.5));
}

TEST_CASE("sides: an end on a turned side stays there where a fault's edge passes it", "[arrangement]") {
  for (unsigned seed = 0; seed < 30; ++seed) {
    INFO("seed " << seed);
    Case c(seed, 0.5);
    const auto ending = horizon(c.frame, 0);
    // Its long edge crosses the side's plane above the middle of an end of the horizon, by less than the tolerance.
    const double x = (1 + seed % (n - 2) + 0.5) * step,
                 height = 0.5 * (ending.points[seed % (n - 2) + 1].z + ending.points[seed % (n - 2) + 2].z);
    const double above = c.dice.between(0.1, 0.4), slope = c.dice.between(-0.5, 0.5);
    const auto place = [&](double along, double up) {
      return c.frame.place(x + slope * along, along, height + above + up);
    };
    TriangulatedSurface fault;
    fault.name = "f";
    fault.kind = SurfaceKind::fault;
    fault.points = {place(-100, 0), place(400, 0), place(400, 400), place(-100, -400), place(400, -400)};
    fault.triangles = {{0, 1, 2}, {0, 3, 4}, {0, 4, 1}};
    const auto result = c.arrange_all({ending, fault});
    double on_sides = 0;
    for (Index side = 2; side < 8; ++side)
      for (const auto& [a, b] : common_edges(result.soup, 0, side))
        on_sides += std::hypot(result.soup.points[a].x - result.soup.points[b].x,
                               result.soup.points[a].y - result.soup.points[b].y);
    CHECK(on_sides == Approx(4 * width).epsilon(1e-9));
  }
}
