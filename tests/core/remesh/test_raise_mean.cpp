// SPDX-License-Identifier: MIT
// The pass that raises the mean shape.
#include <catch2/catch.hpp>
#include <cmath>

#include "quality/measure/shape.hpp"
#include "refine_bench.hpp"
#include "remesh/passes/improve_passes.hpp"

using namespace geomesh;
using namespace geomesh::remesh;
using namespace refine_models;

namespace {

double mean_worth(const DomainMesh& mesh) {
  double sum = 0;
  for (const CellIndex c : mesh.live_cells()) sum += mesh.measure().worth(mesh.shape_of(c));
  return sum / static_cast<double>(mesh.n_cells());
}

}  // namespace

TEST_CASE("The first pass that raises the mean moves vertices that no flip has touched, later ones fewer",
          "[improve]") {
  Model model = two_boxes(6);
  disturb_inside(model, 3);
  Bench bench(model);
  for (int pass = 0; pass < 20; ++pass) {  // flips alone, until none is left
    const RefineStatistics before = bench.statistics;
    raise_mean(bench.tools, 0, 0, {});
    REQUIRE(bench.statistics.smoothing_moves == 0);
    if (bench.statistics.edge_removals + bench.statistics.face_removals == before.edge_removals + before.face_removals)
      break;
    REQUIRE(pass < 19);
  }
  const double flipped = mean_worth(bench.mesh);
  raise_mean(bench.tools, 0, 3, {});
  const std::size_t n_first = bench.statistics.smoothing_moves;
  const double first = mean_worth(bench.mesh);
  CAPTURE(n_first, flipped, first);
  CHECK(n_first > 100);
  CHECK(first > flipped + 0.01);
  std::size_t n_last = 0;
  for (int pass = 0; pass < 3; ++pass) {
    const std::size_t n_before = bench.statistics.smoothing_moves;
    raise_mean(bench.tools, 0, 3, {});
    n_last = bench.statistics.smoothing_moves - n_before;
  }
  CHECK(n_last < n_first / 2);
  CHECK(mean_worth(bench.mesh) >= first);
  CHECK(bench.mesh.validate() == "");
}

TEST_CASE("Flips that raise the mean are the same wherever the model lies", "[improve]") {
  Model model = ball_in_box(4);
  disturb_inside(model, 5);
  for (Vec3& p : model.mesh.points)  // steps that are exact far from the origin, too
    for (std::size_t i = 0; i < 3; ++i) p[i] = std::ldexp(std::round(std::ldexp(p[i], 20)), -20);
  std::vector<RefineStatistics> done;
  for (const double shift : {0.0, 64.0, -1024.0}) {
    Model moved = model;
    for (auto* points : {&moved.mesh.points, &moved.plc.points})
      for (Vec3& p : *points) p = p + Vec3{shift, 2 * shift, -shift};
    Bench bench(std::move(moved));
    raise_mean(bench.tools, 0, 0, {});
    done.push_back(bench.statistics);
  }
  REQUIRE(done[0].edge_removals > 10);
  for (const RefineStatistics& other : done) CHECK(other.edge_removals == done[0].edge_removals);
}
