// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces from points, remade and smoothed, against surfaces that are known.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/gridding.hpp"
#include "geomesh/geomodel/info.hpp"
#include "geomesh/geomodel/readers.hpp"
#include "test_places.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

constexpr double east = 550000, north = 7820000;

/// Scattered places with a height each; the same ones every time.
template <class Height>
std::vector<Vec3> scatter(std::size_t n, double width, Height height) {
  std::vector<Vec3> points;
  std::uint64_t state = 7;
  const auto random = [&] {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state >> 11) / 9007199254740992.0;
  };
  for (std::size_t i = 0; i < n; ++i) {
    const double x = width * random(), y = width * random();
    points.push_back({east + x, north + y, height(x, y)});
  }
  return points;
}

double plane(double x, double y) { return -2000 + x / 8 - y / 4; }
double wave(double x, double y) { return -2000 + 40 * std::sin(x / 400) * std::cos(y / 500); }

/// A square height field of n by n cells of 10 m.
template <class Height>
TriangulatedSurface sheet(std::size_t n, Height height) {
  TriangulatedSurface s;
  s.name = "sheet";
  for (std::size_t j = 0; j <= n; ++j)
    for (std::size_t i = 0; i <= n; ++i) {
      const double x = 10.0 * static_cast<double>(i), y = 10.0 * static_cast<double>(j);
      s.points.push_back({east + x, north + y, height(x, y)});
    }
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      const auto a = static_cast<VertexIndex>(j * (n + 1) + i), d = static_cast<VertexIndex>(a + n + 1);
      s.triangles.push_back({a, a + 1, d + 1});
      s.triangles.push_back({a, d + 1, d});
    }
  return s;
}

template <class Height>
double largest_error(const TriangulatedSurface& s, Height height, double margin) {
  Box3 bounds;
  for (const Vec3& p : s.points) bounds.add(p);
  double error = 0;
  for (const Vec3& p : s.points) {
    const bool inside = p.x > bounds.min.x + margin && p.x < bounds.max.x - margin && p.y > bounds.min.y + margin &&
                        p.y < bounds.max.y - margin;
    if (inside) error = std::max(error, std::abs(p.z - height(p.x - east, p.y - north)));
  }
  return error;
}

}  // namespace

TEST_CASE("a thin plate through points of a plane is that plane, beyond the points too", "[gridding]") {
  const Box3 box{{east - 500, north - 500, -5000}, {east + 2500, north + 2500, 0}};
  GriddingSpec spec;
  spec.to_box = true;
  spec.smoothing = 100;
  const GriddedSurface made = grid_points(scatter(300, 2000, plane), spec, GraphOver::map, &box);
  CHECK(largest_error(made.surface, plane, 0) < 1e-6);
  CHECK(std::abs(made.largest_residual) < 1e-6);
  CHECK(made.n_outside == 0);
  Box3 bounds;
  for (const Vec3& p : made.surface.points) bounds.add(p);
  CHECK(bounds.min.x == box.min.x);
  CHECK(bounds.max.y == Approx(box.max.y).epsilon(1e-15));
}

TEST_CASE("a thin plate follows a wave, and more points bring it nearer", "[gridding]") {
  const GriddedSurface few = grid_points(scatter(400, 2000, wave), {}, GraphOver::map, nullptr);
  const GriddedSurface many = grid_points(scatter(6400, 2000, wave), {}, GraphOver::map, nullptr);
  CHECK(largest_error(few.surface, wave, 200) < 4);  // of an amplitude of 40
  CHECK(largest_error(many.surface, wave, 200) < 0.25);
  CHECK(many.rms_residual < 0.05);
}

TEST_CASE("smoothing takes out noise and tells what it left", "[gridding]") {
  auto points = scatter(4000, 2000, wave);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].z += i % 2 ? 5 : -5;
  GriddingSpec spec;
  spec.smoothing = 80;
  const GriddedSurface smooth = grid_points(points, spec, GraphOver::map, nullptr);
  CHECK(largest_error(smooth.surface, wave, 200) < 2.5);
  CHECK(smooth.rms_residual == Approx(5).epsilon(0.1));
  CHECK(std::abs(smooth.largest_residual) > 5);
  CHECK(grid_points(points, {}, GraphOver::map, nullptr).rms_residual < smooth.rms_residual);
}

TEST_CASE("a hundred thousand points are gridded", "[gridding]") {
  const GriddedSurface made = grid_points(scatter(100000, 2000, wave), {}, GraphOver::map, nullptr);
  CHECK(made.n_nodes <= 41000);
  CHECK(largest_error(made.surface, wave, 100) < 0.05);
}

TEST_CASE("nodes far from every point are left out", "[gridding]") {
  auto points = scatter(2000, 2000, plane);
  std::erase_if(points, [](const Vec3& p) { return std::hypot(p.x - east - 1000, p.y - north - 1000) < 500; });
  GriddingSpec spec;
  spec.spacing = 50;
  spec.max_distance = 150;
  const SurfaceInfo info = measure_surface(grid_points(points, spec, GraphOver::map, nullptr).surface);
  CHECK(info.n_holes == 1);
}

TEST_CASE("points are triangulated as they are where asked", "[gridding]") {
  const auto points = scatter(500, 2000, wave);
  GriddingSpec spec;
  spec.method = GriddingSpec::Method::triangulate;
  const GriddedSurface made = grid_points(points, spec, GraphOver::map, nullptr);
  CHECK(made.surface.points == points);
  CHECK(std::abs(made.largest_residual) < 1e-9);
  const SurfaceInfo info = measure_surface(made.surface);
  CHECK(info.n_borders == 1);
  CHECK(info.n_components == 1);
}

TEST_CASE("points of an upright fault are gridded in their mean plane", "[gridding]") {
  std::vector<Vec3> points;
  for (const Vec3& p : scatter(500, 2000, [](double, double) { return 0.0; })) {
    const double u = p.x - east, v = p.y - north;
    points.push_back({east + 0.6 * u + 10 * std::sin(v / 500), north + 0.8 * u, -v});
  }
  const GriddedSurface made = grid_points(points, {}, GraphOver::mean_plane, nullptr);
  CHECK(made.rms_residual < 0.5);
  CHECK(measure_surface(made.surface).area == Approx(4e6).epsilon(0.03));
}

TEST_CASE("what is no surface is refused", "[gridding]") {
  CHECK_THROWS_AS(grid_points({{0, 0, 0}, {1, 0, 0}}, {}, GraphOver::map, nullptr), Error);
  CHECK_THROWS_AS(grid_points({{0, 0, 0}, {1, 1, 5}, {2, 2, 1}, {7, 7, 0}}, {}, GraphOver::map, nullptr), Error);
  GriddingSpec fine;
  fine.spacing = 1e-3;
  CHECK_THROWS_AS(grid_points(scatter(10, 2000, plane), fine, GraphOver::map, nullptr), Error);
}

TEST_CASE("a remade plane is the plane with the edges asked for", "[gridding]") {
  TriangulatedSurface s = sheet(20, plane);
  const double area = measure_surface(s).area;
  const SurfaceChange change = resample_surface(s, 25, GraphOver::map);
  CHECK(largest_error(s, plane, -1) < 1e-9);
  CHECK(change.largest_move < 1e-9);
  const SurfaceInfo info = measure_surface(s);
  CHECK(info.area == Approx(area).epsilon(1e-12));  // the corners stay
  CHECK(info.n_borders == 1);
  CHECK(info.n_border_edges == 4 * 8);
  CHECK(s.triangles.size() < 200);
  CHECK(s.triangles.size() > 100);
}

TEST_CASE("a remade surface keeps its hole and lies on the old one", "[gridding]") {
  TriangulatedSurface s = sheet(40, wave);
  std::erase_if(s.triangles, [&](const Triangle& t) {
    const Vec3 c = (1.0 / 3) * (s.points[t[0]] + s.points[t[1]] + s.points[t[2]]);
    return std::hypot(c.x - east - 200, c.y - north - 200) < 80;
  });
  const SurfaceChange change = resample_surface(s, 15, GraphOver::map);
  const SurfaceInfo info = measure_surface(s);
  CHECK(info.n_holes == 1);
  CHECK(info.n_components == 1);
  CHECK(change.largest_move < 0.5);
  CHECK(info.n_misoriented_edges == 0);
}

TEST_CASE("closed and folded surfaces are not remade", "[gridding]") {
  TriangulatedSurface s = sheet(4, plane);
  std::swap(s.triangles[3][0], s.triangles[3][1]);
  CHECK_THROWS_AS(resample_surface(s, 10, GraphOver::map), Error);
  TriangulatedSurface closed;
  closed.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  closed.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  CHECK_THROWS_AS(resample_surface(closed, 0.5, GraphOver::map), Error);
}

TEST_CASE("smoothing leaves planes and borders, and takes out noise", "[gridding]") {
  TriangulatedSurface flat = sheet(20, plane);
  CHECK(smooth_surface(flat, 5, GraphOver::map).largest_move < 1e-9);
  CHECK(smooth_surface(flat, 5, GraphOver::mean_plane).largest_move < 1e-9);
  const auto noise = [](double x, double y) {
    return (static_cast<int>(x / 10) * 7 + static_cast<int>(y / 10) * 13) % 5 - 2.0;
  };
  TriangulatedSurface rough = sheet(20, [&](double x, double y) { return plane(x, y) + noise(x, y); });
  const std::vector<Vec3> before = rough.points;
  smooth_surface(rough, 10, GraphOver::map);
  CHECK(largest_error(rough, plane, 15) < 0.7);
  for (std::size_t i = 0; i < before.size(); ++i) {
    CHECK(rough.points[i].x == before[i].x);
    const bool on_border = i < 21 || i >= 420 || i % 21 == 0 || i % 21 == 20;
    if (on_border) CHECK(rough.points[i] == before[i]);
  }
}

TEST_CASE("the points of Claudius become surfaces", "[gridding][shared]") {
  const std::filesystem::path file = std::filesystem::path(GEOMESH_SHARED_DATA) / "claudius/claudius.csv";
  if (!std::filesystem::exists(file)) {
    WARN("skipped: no folder of outside test data");
    return;
  }
  const FileContents contents = read_surface_file(file);
  std::vector<std::string> names;
  for (const PointSet& s : contents.point_sets) names.push_back(s.name);
  for (const TriangulatedSurface& s : contents.surfaces) names.push_back(s.name);
  std::sort(names.begin(), names.end());
  CHECK(names == std::vector<std::string>{"(none)", "0.0", "250.0", "330.0", "60.0"});
  for (const PointSet& set : contents.point_sets) {
    if (set.name == "(none)") continue;
    INFO(set.name);
    GriddingSpec spec;
    spec.spacing = 25;
    spec.max_distance = 60;
    const GriddedSurface made = grid_points(set.points, spec, GraphOver::map, nullptr);
    CHECK(made.rms_residual < 2);
    CHECK(made.n_outside < set.points.size() / 50);
  }
}
