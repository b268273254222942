// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <set>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/arrangement.hpp"
#include "geomesh/geomodel/model_volume.hpp"
#include "naming/sheets.hpp"
#include "naming/sums.hpp"
#include "require_sound.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

TriangulatedSurface tilted_sheet() {
  TriangulatedSurface s;
  s.name = std::string("h");
  s.kind = SurfaceKind::horizon;
  s.points = {{-50, -50, -7}, {150, -50, 3}, {150, 150, 6}, {-50, 150, -4}};
  s.triangles = {{0, 1, 2}, {0, 2, 3}};
  return s;
}

/// The sides as one surface.
TriangulatedSurface hull_of(const ModelVolume& volume) {
  TriangulatedSurface all;
  for (const TriangulatedSurface& side : volume.sides) {
    const auto first = static_cast<VertexIndex>(all.points.size());
    all.points.insert(all.points.end(), side.points.begin(), side.points.end());
    for (const Triangle& t : side.triangles) all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return all;
}

double enclosed(const TriangulatedSurface& s) {
  double six = 0;
  for (const Triangle& t : s.triangles) six += dot(s.points[t[0]], cross(s.points[t[1]], s.points[t[2]]));
  return six / 6;
}

std::string message_of(const VolumeSpec& spec, const std::vector<TriangulatedSurface>& surfaces = {}) {
  try {
    make_volume(spec, surfaces, {});
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::usage);
    return error.what();
  }
  return "";
}

VolumeSpec l_shape() {
  VolumeSpec spec;
  spec.shape = VolumeSpec::Shape::polygon;
  spec.polygon = {{0, 0}, {80, 0}, {80, 30}, {30, 30}, {30, 70}, {0, 70}};
  spec.bottom = -20;
  spec.top = 10;
  return spec;
}
constexpr double l_area = 80 * 30 + 30 * 40;

}  // namespace

TEST_CASE("a box by margin holds the data with that much room, turned or not", "[volume]") {
  VolumeSpec spec;
  spec.shape = VolumeSpec::Shape::margin;
  spec.margin = {1, 2, 3};
  const ModelVolume plain = make_volume(spec, {tilted_sheet()}, {});
  REQUIRE(plain.box);
  CHECK(plain.box->min == Vec3{-51, -52, -10});
  CHECK(plain.box->max == Vec3{151, 152, 9});
  CHECK(plain.note.find("-51") != std::string::npos);
  spec.azimuth = 45;
  spec.bottom = -100;
  const ModelVolume turned = make_volume(spec, {tilted_sheet()}, {});
  CHECK_FALSE(turned.box);
  const double diagonal = 200 * std::sqrt(2.0);
  CHECK(turned.volume == Approx((diagonal + 2) * (diagonal + 4) * 109));
  CHECK(message_of(spec).find("margin") != std::string::npos);
}

TEST_CASE("sides of turned boxes and of polygons close and face outwards, whichever way the polygon runs", "[volume]") {
  VolumeSpec turned;
  turned.shape = VolumeSpec::Shape::turned;
  turned.center = {500, 700};
  turned.size = {40, 60};
  turned.azimuth = 30;
  turned.bottom = -5;
  turned.top = 5;
  const ModelVolume box = make_volume(turned, {}, {100, 200, 1});
  CHECK(is_closed(hull_of(box)));
  CHECK(enclosed(hull_of(box)) == Approx(24000));
  CHECK(box.volume == Approx(24000).epsilon(1e-14));
  std::set<std::string> names;
  for (const TriangulatedSurface& side : box.sides) names.insert(side.name);
  CHECK(names == std::set<std::string>{"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"});
  for (const TriangulatedSurface& side : box.sides) {  // ymax looks along the azimuth, xmax 90 degrees to its right
    const Vec3 n = cross(side.points[1] - side.points[0], side.points[2] - side.points[0]);
    if (side.name == "ymax") CHECK(std::atan2(n.x, n.y) * 180 / std::numbers::pi == Approx(30));
    if (side.name == "xmax") CHECK(std::atan2(n.x, n.y) * 180 / std::numbers::pi == Approx(120));
    if (side.name == "zmax") CHECK(side.points[0].z == 4);
  }
  VolumeSpec polygon = l_shape();
  for (int turn = 0; turn < 2; ++turn) {
    const ModelVolume volume = make_volume(polygon, {}, {});
    CHECK(is_closed(hull_of(volume)));
    CHECK(enclosed(hull_of(volume)) == Approx(30 * l_area));
    CHECK(volume.volume == 30 * l_area);
    CHECK(volume.sides.size() == 8);
    CHECK(volume.sides[0].name == "side_1");
    std::reverse(polygon.polygon.begin(), polygon.polygon.end());
  }
}

TEST_CASE("a polygon far from the origin is the same volume, whichever way it turns", "[volume]") {
  for (const Vec2 far : {Vec2{4e5, 6.5e6}, Vec2{-4e5, 6.5e6}, Vec2{4e5, -6.5e6}, Vec2{-4e5, -6.5e6}}) {
    VolumeSpec polygon = l_shape();
    for (Vec2& p : polygon.polygon) p = {p.x + far.x, p.y + far.y};
    for (int turn = 0; turn < 2; ++turn) {
      const ModelVolume volume = make_volume(polygon, {}, {far.x, far.y, 0});
      CHECK(is_closed(hull_of(volume)));
      CHECK(enclosed(hull_of(volume)) == Approx(30 * l_area));
      std::reverse(polygon.polygon.begin(), polygon.polygon.end());
    }
  }
}

TEST_CASE("polygons that cross themselves and volumes without height are refused", "[volume]") {
  VolumeSpec spec = l_shape();
  std::swap(spec.polygon[1], spec.polygon[3]);
  CHECK(message_of(spec).find("crosses") != std::string::npos);
  spec = l_shape();
  spec.polygon[3] = spec.polygon[0];
  CHECK(message_of(spec).find("corner twice") != std::string::npos);
  spec = l_shape();
  spec.top = -20;
  CHECK(message_of(spec).find("not below") != std::string::npos);
  spec = l_shape();
  spec.top.reset();
  spec.top_surface = "nowhere";
  CHECK(message_of(spec, {tilted_sheet()}).find("nowhere") != std::string::npos);
}

TEST_CASE("the arrangement keeps what is in the volume: surfaces, wells, points, areas that add up", "[volume]") {
  const ModelVolume volume = make_volume(l_shape(), {}, {});
  ArrangementOptions options;
  options.volume = volume.sides;
  const TriangulatedSurface sheet = tilted_sheet();
  const Polyline through{"through", "", {{-10, 50, 5}, {100, 50, 5}}};    // inside for x in 0..30 alone
  const Polyline on_side{"on_side", "", {{30, 30, -10}, {30, 70, -10}}};  // along a side
  const std::vector<NamedPoint> points{{"in", {10, 10, 9}}, {"notch", {60, 50, 9}}, {"corner", {0, 0, 10}}};
  const ArrangementResult result = arrange({sheet}, {through, on_side}, points, options);
  testing::require_sound(result.soup);
  double area = 0, whole = 0;
  for (Index f = 0; f < result.soup.facets.size(); ++f)
    for (Index o = result.soup.origin_offsets[f]; o < result.soup.origin_offsets[f + 1]; ++o)
      if (result.soup.origins[o].surface == 0) {
        const Triangle& t = result.soup.facets[f];
        area += triangle_area(result.soup.points[t[0]], result.soup.points[t[1]], result.soup.points[t[2]]);
      }
  for (const Triangle& t : sheet.triangles)
    whole += triangle_area(sheet.points[t[0]], sheet.points[t[1]], sheet.points[t[2]]);
  const double slant = std::sqrt(1 + 0.05 * 0.05 + 0.015 * 0.015);
  CHECK(area == Approx(l_area * slant).epsilon(1e-12));
  CHECK(result.area_clipped_by_box[0] == Approx(whole - area).epsilon(1e-12));
  std::array<double, 2> length{0, 0};
  for (const auto& s : result.soup.segments)
    length[s.polyline] += norm(result.soup.points[s.a] - result.soup.points[s.b]);
  CHECK(length[0] == Approx(30));
  CHECK(length[1] == Approx(40));
  std::set<Index> kept;
  for (const auto& p : result.soup.isolated_points) kept.insert(p.point);
  CHECK(kept == std::set<Index>{0, 2});
  CHECK(std::any_of(result.warnings.begin(), result.warnings.end(),
                    [](const std::string& w) { return w.find("notch") != std::string::npos; }));
}
