// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces that end within rounding of others.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "arrangement/join/join_surfaces.hpp"
#include "arrangement/model/ingest.hpp"
#include "arrangement_inputs.hpp"
#include "common_edges.hpp"
#include "require_sound.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;

namespace {

/// A fault that dips along x, of 2 n x n triangles, from (0, 0, -600) on.
TriangulatedSurface fault(unsigned n, double dip) {
  return grid_surface("fault", SurfaceKind::fault, n, 0, 900, 0, 2100,
                      [&](double x, double) { return -600 + dip * x; });
}

/// Ends on that fault, at heights that waver: its points there are on the fault but for rounding.
TriangulatedSurface horizon(unsigned n, double dip, double wave, double side) {
  auto surface = grid_surface("horizon", SurfaceKind::horizon, n, 0, 1, 60, 2000, [](double, double) { return 0; });
  for (Vec3& p : surface.points) {
    const double height = -300 + wave * std::sin(p.y / 170), foot = (height + 600) / dip;
    p = {foot + side * 700 * p.x, p.y, height + 30 * p.x};
  }
  return surface;
}

double common_length(const PolygonSoup& soup) {
  double sum = 0;
  for (const auto& [a, b] : common_edges(soup, 0, 1)) sum += arrangement::length(soup.points[a] - soup.points[b]);
  return sum;
}

double border_length(const TriangulatedSurface& horizon, unsigned n) {
  double sum = 0;
  for (unsigned j = 0; j < n; ++j)
    sum += arrangement::length(horizon.points[(j + 1) * (n + 1)] - horizon.points[j * (n + 1)]);
  return sum;
}

}  // namespace

TEST_CASE("ends: a horizon that ends on a fault to rounding has all of its border there", "[arrangement]") {
  std::mt19937 chance(11);
  std::uniform_real_distribution<double> any(0, 1);
  for (int k = 0; k < 60; ++k) {
    const unsigned n = 2 + static_cast<unsigned>(5 * any(chance));
    const double dip = 0.4 + 2 * any(chance), wave = 40 * any(chance), side = k % 2 == 0 ? 1 : -1;
    const auto ending = horizon(n, dip, wave, side);
    ArrangementOptions options;
    options.box = Box3{{-900, 0, -1000}, {1800, 2100, 2000}};
    const auto result = arrange({ending, fault(3 + k % 4, dip)}, {}, {}, options);
    INFO("case " << k << ", " << n << " cells, dip " << dip);
    require_sound(result.soup);
    CHECK(common_length(result.soup) == Approx(border_length(ending, n)).epsilon(1e-9));
    CHECK(result.merging.displacement.largest < 32 * 0x1p-42);
  }
}

TEST_CASE("ends: what is exactly on another surface, or plainly across it, is left to the intersection",
          "[arrangement]") {
  const auto wall = triangles("wall", {{Vec3{0, 0, 0}, Vec3{8, 0, 0}, Vec3{0, 0, 8}}});
  for (const double y : {0.0, -2.0, 0x1p-20}) {
    const auto floor = triangles("floor", {{Vec3{1, y, 1}, Vec3{3, y, 2}, Vec3{2, 5, 1}}});
    const std::vector<TriangulatedSurface> given{wall, floor}, none;
    auto ingested = arrangement::ingest({given, none}, {}, {}, std::nullopt);
    std::vector<VertexIndex> now;
    CHECK_FALSE(arrangement::join_ends(ingested.complex, {32 * 0x1p-49, std::nullopt, 2, false}, now));
  }
}
