// SPDX-License-Identifier: GPL-3.0-or-later
// Faces of second order against a surface: all of a face, and not its nodes alone.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "geomesh/core/surface_distance.hpp"
#include "solver_mesh/curved_face.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

/// A square from -1 to 2 with the height f(x, y), of 2 n^2 triangles.
template <class F>
SurfaceDistance surface_over(int n, F&& f) {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  const auto row = [&](int i, int j) { return static_cast<VertexIndex>(i * (n + 1) + j); };
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double x = -1 + 3.0 * i / n, y = -1 + 3.0 * j / n;
      points.push_back({x, y, f(x, y)});
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      triangles.push_back({row(i, j), row(i + 1, j), row(i + 1, j + 1)});
      triangles.push_back({row(i, j), row(i + 1, j + 1), row(i, j + 1)});
    }
  return {points, triangles};
}

const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};

}  // namespace

TEST_CASE("a face whose nodes are near a surface and whose middle is not is told", "[writers][curved]") {
  const double h = 0.01;
  const Vec3 up{0, 0, h};
  const std::array<Vec3, 6> bulge{a, b, c, 0.5 * (a + b) + up, 0.5 * (b + c) + up, 0.5 * (c + a) + up};
  const double third = 1.0 / 3;
  CHECK(place_on_face(bulge, {third, third, third}).z == Approx(4 * h / 3));
  for (const int n : {1, 7, 40}) {
    const SurfaceDistance plane = surface_over(n, [](double, double) { return 0.0; });
    CHECK(!is_face_within(bulge, plane, 0.5 * h));
    CHECK(!is_face_within(bulge, plane, 1.2 * h));  // the nodes are nearer
    CHECK(!is_face_within(bulge, plane, 1.33 * h));
    CHECK(is_face_within(bulge, plane, 1.4 * h));
    CHECK(is_face_within(bulge, plane, 10 * h));
  }
}

TEST_CASE("a face that follows a curved surface is proven within less than its flat corners are", "[writers][curved]") {
  const auto height = [](double x, double y) { return 0.1 * x * x + 0.05 * x * y; };
  const SurfaceDistance surface = surface_over(120, height);
  const auto on = [&](const Vec3& p) { return Vec3{p.x, p.y, height(p.x, p.y)}; };
  const std::array<Vec3, 3> corner{on(a), on(b), on(c)};
  std::array<Vec3, 6> curved{corner[0], corner[1], corner[2]}, flat = curved;
  for (std::size_t i = 0; i < 3; ++i) {
    flat[3 + i] = 0.5 * (corner[i] + corner[(i + 1) % 3]);
    curved[3 + i] = on(flat[3 + i]);
  }
  const double limit = 0.004;  // the edges' middles are 0.025 off; the curved face is on the surface
  CHECK(is_face_within(curved, surface, limit));
  CHECK(!is_face_within(flat, surface, limit));
}

TEST_CASE("a face over a hole of the surface is not within it", "[writers][curved]") {
  std::vector<Vec3> points{{-1, -1, 0}, {2, -1, 0}, {2, 0.2, 0}, {-1, 0.2, 0}};
  const std::vector<Triangle> triangles{{0, 1, 2}, {0, 2, 3}};
  const SurfaceDistance strip(points, triangles);
  const std::array<Vec3, 6> face{a, b, c, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)};
  CHECK(!is_face_within(face, strip, 0.7));
  CHECK(is_face_within(face, strip, 0.9));
  CHECK(strip.closest({0, 1, 0}).y == Approx(0.2));
}
