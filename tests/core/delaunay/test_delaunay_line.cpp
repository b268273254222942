// SPDX-License-Identifier: GPL-3.0-or-later
// Many points on one line, and the few that make it a body: the work is linear.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "geomesh/core/delaunay.hpp"
#include "geomesh/core/validate.hpp"

using namespace geomesh;

namespace {

std::vector<Vec3> line_in_cube(unsigned n) {
  std::vector<Vec3> points;
  for (unsigned corner = 0; corner < 8; ++corner)
    points.push_back({corner & 1 ? 35.0 : -33, corner & 2 ? 35.0 : -33, corner & 4 ? 35.0 : -33});
  for (unsigned corner = 0; corner < 8; ++corner)
    points.push_back({corner & 1 ? 2.0 : -1, corner & 2 ? 2.0 : -1, corner & 4 ? 2.0 : -1});
  for (unsigned i = 0; i < n; ++i) {
    const double t = std::ldexp(i, -20);
    points.push_back({t, 0.5 * t, 0.25 * t});
  }
  return points;
}

}  // namespace

TEST_CASE("Delaunay: 200,000 points on one line take a bounded number of steps each", "[delaunay]") {
  const std::vector<Vec3> points = line_in_cube(200000);
  const auto result = delaunay_tetrahedralization(points);
  CHECK(result.statistics.walk_steps < 60 * points.size());
  CHECK(validate_topology(result.mesh).empty());
}
