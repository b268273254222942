// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Gmpq.h>

#include <catch2/catch.hpp>
#include <random>

#include "recover/exact/exact_places.hpp"
#include "recover/operations/side_masks.hpp"

using namespace geomesh;
using namespace geomesh::recover;
using exact::LongExpansion;

namespace {

CGAL::Gmpq value(const LongExpansion& e) {
  CGAL::Gmpq out(0);
  for (const double t : e.terms()) out += CGAL::Gmpq(t);
  return out;
}

int exact_sign(const ExactPlaces& places, const std::vector<Vec3>& points, const std::array<VertexIndex, 4>& v) {
  std::array<std::array<CGAL::Gmpq, 3>, 3> d;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i)
      d[k][i] = value(places.coordinate(points, v[k + 1], i)) - value(places.coordinate(points, v[0], i));
  return CGAL::sign(d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) +
                    d[0][1] * (d[1][2] * d[2][0] - d[1][0] * d[2][2]) +
                    d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]));
}

/// Four vertices that are doubles, then points on the segment 0-1 and in the plane of 0, 1, 2, some of them 2^-90
/// apart.
struct Scene {
  std::vector<Vec3> points;
  ExactPlaces places;

  explicit Scene(unsigned seed) {
    std::mt19937 random(seed);
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    for (int i = 0; i < 4; ++i) points.push_back({16000 * unit(), 9000 * unit(), -5000 * unit()});
    for (int i = 0; i < 6; ++i) {
      const LongExpansion t = LongExpansion(unit()) + LongExpansion(i % 2 == 0 ? 0.0 : 0x1p-90),
                          u = i < 3 ? LongExpansion() : LongExpansion(0.5 * unit());
      ExactPlace place;
      for (std::size_t k = 0; k < 3; ++k) {
        const LongExpansion o(points[0][k]);
        place.coordinates[k] = o + t * (LongExpansion(points[1][k]) - o) + u * (LongExpansion(points[2][k]) - o);
      }
      place.frame = {0, 1, i < 3 ? no_vertex : 2};
      place.parameter = t;
      points.push_back(place.nearest());
      places.set(static_cast<VertexIndex>(points.size() - 1), place);
      if (i % 2 == 1) continue;
      place.coordinates[0] = place.coordinates[0] + LongExpansion(0x1p-90);  // beside it, off its plane
      place.frame = {no_vertex, no_vertex, no_vertex};
      points.push_back(place.nearest());
      places.set(static_cast<VertexIndex>(points.size() - 1), place);
    }
  }
};

}  // namespace

TEST_CASE("orientation of exact places is that of exact rational numbers, also where nearest doubles are equal",
          "[recover]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Scene scene(seed);
    std::mt19937 random(seed);
    const auto n = static_cast<VertexIndex>(scene.points.size());
    for (int i = 0; i < 300; ++i) {
      const auto below = [&](VertexIndex end) { return static_cast<VertexIndex>(random() % end); };
      const std::array<VertexIndex, 4> v{below(n), below(n), below(n), 4 + below(n - 4)};
      INFO("seed " << seed << ": " << v[0] << ' ' << v[1] << ' ' << v[2] << ' ' << v[3]);
      REQUIRE(static_cast<int>(scene.places.orient(scene.points, v)) == exact_sign(scene.places, scene.points, v));
    }
  }
}

TEST_CASE("side masks tell the same of vertices that are exact places, one triple after the other", "[recover]") {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Scene scene(seed);
    ConstrainedMesh mesh({}, {scene.points.begin(), scene.points.begin() + 4}, 4);
    for (VertexIndex v = 4; v < scene.points.size(); ++v) mesh.add_point(scene.places.of(v));
    std::vector<VertexIndex> vertices;
    for (VertexIndex v = 0; v < scene.points.size(); ++v) vertices.push_back(v);
    SideMasks sides(mesh, vertices);
    const auto n = static_cast<LocalVertex>(vertices.size());
    for (LocalVertex a = 0; a < n; ++a)
      for (LocalVertex b = 0; b < a; ++b)
        for (LocalVertex c = 0; c < b; ++c)
          for (LocalVertex d = 0; d < n; ++d) {
            if (d == a || d == b || d == c) continue;
            INFO("seed " << seed << ": " << +a << ' ' << +b << ' ' << +c << ' ' << +d);
            REQUIRE(sides.sign(a, b, c, d) == exact_sign(scene.places, scene.points, {a, b, c, d}));
          }
  }
}

TEST_CASE("an exact place that is taken out leaves the others as they were", "[recover]") {
  Scene scene(1);
  const auto last = static_cast<VertexIndex>(scene.points.size() - 1);
  const LongExpansion before = scene.places.coordinate(scene.points, last, 0);
  scene.places.erase(4);
  CHECK_FALSE(scene.places.contains(4));
  CHECK(scene.places.contains(last));
  CHECK(value(scene.places.coordinate(scene.points, last, 0)) == value(before));
  for (VertexIndex v = 5; v <= last; ++v) scene.places.erase(v);
  CHECK(scene.places.empty());
}
