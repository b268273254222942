// SPDX-License-Identifier: GPL-3.0-or-later
// Parallel insertion: the same cells in the same slots on any number of threads, and a valid triangulation.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "geomesh/core/delaunay.hpp"
#include "geomesh/core/validate.hpp"

using namespace geomesh;

namespace {

std::vector<Vec3> points_of_kind(int kind, std::size_t n) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<Vec3> points(n);
  for (std::size_t i = 0; i < n; ++i) {
    Vec3& p = points[i];
    p = {coordinate(random), coordinate(random), coordinate(random)};
    if (kind == 1)
      p = {double(random() % 60), double(random() % 60), double(random() % 60)};  // a lattice with equal points
    if (kind == 2) p = std::pow(10.0, -double(i % 8)) * p;                        // crowded towards the middle
  }
  return points;
}

}  // namespace

TEST_CASE("Delaunay: the same bytes on 1, 2 and 5 threads", "[delaunay]") {
  for (const int kind : {0, 1, 2})
    for (const double distance : {-1.0, 0.02}) {
      const auto points = points_of_kind(kind, 120000);
      DelaunayOptions options;
      options.cluster_distance = distance;
      RunContext context;
      context.threads = 1;
      const auto one = delaunay_tetrahedralization(points, options, context);
      CHECK(validate_topology(one.mesh).empty());
      CHECK(validate_geometry(one.mesh, points).empty());
      CHECK(validate_delaunay(one.mesh, points).empty());
      for (const unsigned threads : {2u, 5u}) {
        context.threads = threads;
        const auto many = delaunay_tetrahedralization(points, options, context);
        REQUIRE(many.mesh.n_slots() == one.mesh.n_slots());
        bool same = many.representative == one.representative;
        for (CellIndex c = 0; c < one.mesh.n_slots(); ++c)
          same = same && one.mesh.vertices(c) == many.mesh.vertices(c) &&
                 one.mesh.cells()[c].neighbors == many.mesh.cells()[c].neighbors;
        CHECK(same);
        CHECK(many.statistics.points_deferred == one.statistics.points_deferred);
      }
    }
}
