// SPDX-License-Identifier: GPL-3.0-or-later
// Isosurfaces of fields whose surfaces are known: how far they are off, what they enclose, and that they never cross.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/arrangement.hpp"
#include "level_sets/distance_proof.hpp"
#include "level_sets/fields/function_field.hpp"
#include "level_sets/isosurfaces_of_field.hpp"
#include "level_sets/sheet_topology.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

using Function = std::function<double(const Vec3&)>;

Box3 cube() {
  Box3 box;
  box.add({-500, -500, -500});
  box.add({500, 500, 500});
  return box;
}

FieldSurfaces of_function(const Function& f, const std::vector<double>& values, double distance) {
  const auto function = std::make_shared<FieldFunction>([f](std::span<const Vec3> places, std::span<double> out) {
    for (std::size_t i = 0; i < places.size(); ++i) out[i] = f(places[i]);
  });
  return isosurfaces_of(FunctionField(function, cube(), "top"), cube(), values, distance);
}

GridField on_grid(const Function& f, std::size_t cells) {
  GridField::Lattice lattice;
  lattice.n = {cells + 1, cells + 1, cells + 1};
  lattice.origin = cube().min;
  const double step = 1000.0 / static_cast<double>(cells);
  lattice.spacing = {step, step, step};
  for (std::size_t k = 0; k <= cells; ++k)
    for (std::size_t j = 0; j <= cells; ++j)
      for (std::size_t i = 0; i <= cells; ++i)
        lattice.nodes.push_back(f(lattice.origin + step * Vec3{double(i), double(j), double(k)}));
  return GridField(std::move(lattice));
}

TriangulatedSurface as_surface(const Isosurface& isosurface, const std::string& name) {
  TriangulatedSurface surface;
  surface.name = name;
  surface.kind = SurfaceKind::horizon;
  surface.points = isosurface.points;
  surface.triangles = isosurface.triangles;
  return surface;
}

double enclosed(const Isosurface& s) {
  double six = 0;
  for (const Triangle& t : s.triangles) six += dot(s.points[t[0]], cross(s.points[t[1]], s.points[t[2]]));
  return six / 6;
}

struct Off {
  double farthest = 0;
  std::size_t n_beyond = 0;  ///< samples farther than the distance
};

/// |f - value| at samples spread over the triangles: of a field that is a signed distance, the distance.
Off off_at_samples(const Isosurface& s, const Function& f, double distance, std::size_t n_samples) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0, 1);
  Off off;
  for (std::size_t i = 0; i < n_samples; ++i) {
    const Triangle& t = s.triangles[i % s.triangles.size()];
    double u = share(random), v = share(random);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Vec3 &a = s.points[t[0]], &b = s.points[t[1]], &c = s.points[t[2]];
    const double d = std::abs(f(a + u * (b - a) + v * (c - a)));
    off.farthest = std::max(off.farthest, d);
    off.n_beyond += d > distance;
  }
  return off;
}

double sphere(const Vec3& p) { return std::sqrt(dot(p, p)) - 300; }

double torus(const Vec3& p) { return std::hypot(std::hypot(p.x, p.y) - 300, p.z) - 100; }

/// Two balls of radius 200 with a metre of rock between them.
double spheres_a_metre_apart(const Vec3& p) {
  const Vec3 shift{200.5, 0, 0};
  return std::min(std::sqrt(dot(p - shift, p - shift)), std::sqrt(dot(p + shift, p + shift))) - 200;
}

double fold(const Vec3& p) { return p.z - 80 * std::sin(p.x / 100) - 20 * std::cos(p.y / 150); }

/// A fold on its side: over one place of the map the surface is met three times.
double recumbent_fold(const Vec3& p) { return p.x - 200 * std::sin(p.z / 90) - 0.2 * p.z; }

}  // namespace

TEST_CASE("an isosurface of a distance function is within the distance at all but few of 100,000 samples",
          "[level-sets]") {
  struct Case {
    const char* name;
    Function f;
    double volume;
    std::size_t n_parts;
  };
  const double pi = std::numbers::pi;
  const Case cases[] = {{"sphere", sphere, 4.0 / 3 * pi * 27e6, 1},
                        {"torus", torus, 2 * pi * pi * 300 * 1e4, 1},
                        {"spheres a metre apart", spheres_a_metre_apart, 8.0 / 3 * pi * 8e6, 2}};
  for (const Case& c : cases) {
    INFO(c.name);
    const double distance = 0.3;
    const FieldSurfaces found = of_function(c.f, {0}, distance);
    const SheetTopology topology = topology_of(as_surface(found.surfaces[0], "top"));
    // Each round draws samples of its own: one of the last 20,000 may find a place that no round before has met.
    CHECK(found.beyond[0].size() <= 1);
    CHECK(topology.n_parts == c.n_parts);
    CHECK(topology.n_border_edges == 0);
    CHECK(topology.n_bad_edges == 0);
    // A function has no bounds: what is promised, and noted in the run, is a share of the area.
    const Off off = off_at_samples(found.surfaces[0], c.f, distance, 100'000);
    CHECK(off.n_beyond <= 25);
    CHECK(off.farthest <= 2 * distance);
    CHECK(enclosed(found.surfaces[0]) == Approx(c.volume).epsilon(0.005));
  }
}

TEST_CASE("a trilinear field's isosurface is proven near, and is near the trilinear field itself", "[level-sets]") {
  const double distance = 0.5;
  for (const Function& f : {Function(sphere), Function(torus), Function(fold), Function(recumbent_fold)}) {
    const GridField grid = on_grid(f, 40);
    const FieldSurfaces found = isosurfaces_of(grid, cube(), {0}, distance);
    CHECK(found.is_proven);
    CHECK(found.beyond[0].empty());
    // Independent of the proof: the sign changes between both sides of samples.
    for (const std::uint64_t seed : {11u, 12u, 13u, 14u, 15u})
      CHECK(sample_within(grid, found.surfaces[0], 0, distance, seed).beyond.empty());
  }
}

TEST_CASE("vertices of an isosurface of a linear field are roots of it to rounding", "[level-sets]") {
  const Function inclined = [](const Vec3& p) { return 0.3 * p.x - 0.2 * p.y + p.z; };
  const FieldSurfaces found = of_function(inclined, {-30, 12.5}, 1);
  for (std::size_t v = 0; v < 2; ++v)
    for (const Vec3& p : found.surfaces[v].points) CHECK(std::abs(inclined(p) - (v == 0 ? -30 : 12.5)) < 1e-10);
}

TEST_CASE("isosurfaces enclose the volumes of balls, not those of polyhedra inside of them", "[level-sets]") {
  const std::vector<double> radii{150, 300, 301};
  for (const double distance : {0.5, 2.0}) {
    const FieldSurfaces found = of_function([](const Vec3& p) { return length_of(p); }, radii, distance);
    for (std::size_t v = 0; v < radii.size(); ++v) {
      const double off = enclosed(found.surfaces[v]) - 4.0 / 3 * std::numbers::pi * std::pow(radii[v], 3);
      CHECK(std::abs(off) < 0.1 * distance * 4 * std::numbers::pi * radii[v] * radii[v]);
    }
  }
}

TEST_CASE("isosurfaces of one field never cross, however near their values", "[level-sets]") {
  for (const Function& f : {Function(fold), Function(recumbent_fold)}) {
    const std::vector<double> values{0, 1e-6, 0.01, 1, 2};
    const FieldSurfaces found = of_function(f, values, 2);
    std::vector<TriangulatedSurface> surfaces;
    for (std::size_t v = 0; v < values.size(); ++v)
      surfaces.push_back(as_surface(found.surfaces[v], "s" + std::to_string(v)));
    const ArrangementResult arranged = arrange(surfaces, {}, {}, {});
    CHECK(arranged.n_crossing_pairs == 0);
  }
}

TEST_CASE("an isosurface ends on the sides of the box", "[level-sets]") {
  const FieldSurfaces found = of_function(fold, {0}, 1);
  const TriangulatedSurface surface = as_surface(found.surfaces[0], "top");
  for (const Vec3& p : surface.points) {
    CHECK(std::abs(p.x) <= 500);
    CHECK(std::abs(p.y) <= 500);
  }
  std::size_t n_on_side = 0;
  for (const Vec3& p : surface.points) n_on_side += std::abs(p.x) == 500 || std::abs(p.y) == 500;
  CHECK(n_on_side == topology_of(surface).n_border_edges);
}

TEST_CASE("a plane through the nodes of the mesh is found once, with the triangles of the mesh", "[level-sets]") {
  const FieldSurfaces found = isosurfaces_of(on_grid([](const Vec3& p) { return p.z; }, 8), cube(), {0}, 1);
  const TriangulatedSurface surface = as_surface(found.surfaces[0], "top");
  for (const Vec3& p : surface.points) CHECK(p.z == 0);
  const SheetTopology topology = topology_of(surface);
  CHECK(topology.n_parts == 1);
  CHECK(topology.n_bad_edges == 0);
}

TEST_CASE("a field linear in tetrahedra gives its own isosurface", "[level-sets]") {
  TetrahedralField field;
  field.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  field.cells = {{0, 1, 2, 3}, {1, 2, 3, 4}};
  for (const Vec3& p : field.points) field.values.push_back(p.x + 2 * p.y + 3 * p.z);
  const FieldSurfaces found = isosurfaces_of(field, {1.5, 2.5});
  for (std::size_t v = 0; v < 2; ++v) {
    REQUIRE(!found.surfaces[v].triangles.empty());
    for (const Vec3& p : found.surfaces[v].points) CHECK(p.x + 2 * p.y + 3 * p.z == Approx(v == 0 ? 1.5 : 2.5));
  }
}

TEST_CASE("a function that gives no number is refused with surface and place", "[level-sets]") {
  const auto hole = [](const Vec3& p) { return p.x > 499 ? std::nan("") : p.z; };
  CHECK_THROWS_WITH(of_function(hole, {0}, 1), Catch::Contains("surface top") && Catch::Contains("not finite at (500"));
}

TEST_CASE("bounds of a trilinear field hold at random places", "[level-sets]") {
  const GridField grid = on_grid(torus, 9);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coordinate(-500, 500), share(0, 1);
  for (int trial = 0; trial < 300; ++trial) {
    Box3 box;
    const Vec3 corner{coordinate(random), coordinate(random), coordinate(random)};
    box.add(corner);
    const double reach = trial % 2 == 0 ? 30 : 400;
    Vec3 other;
    for (std::size_t a = 0; a < 3; ++a) other[a] = std::clamp(corner[a] + reach * (share(random) - 0.5), -500.0, 500.0);
    box.add(other);
    const LinearFunction linear{corner, 3, {0.4, -0.2, 0.7}};
    const Range values = grid.value_range(box), residuals = grid.residual_range(box, linear);
    for (int i = 0; i < 20; ++i) {
      Vec3 p;
      for (std::size_t a = 0; a < 3; ++a) p[a] = box.min[a] + share(random) * (box.max[a] - box.min[a]);
      double value;
      grid.values({&p, 1}, {&value, 1});
      CHECK((values.low <= value + 1e-9 && value <= values.high + 1e-9));
      CHECK((residuals.low <= value - linear(p) + 1e-9 && value - linear(p) <= residuals.high + 1e-9));
    }
  }
}
