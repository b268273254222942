// SPDX-License-Identifier: MIT
// The pass that raises the mean shape: the first one looks at all vertices, later ones where it is worth it.
#include <algorithm>
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

std::size_t n_moved(const RaisedBefore& before) {
  return static_cast<std::size_t>(
      std::count_if(before.gains.begin(), before.gains.end(), [](double gain) { return gain > 0; }));
}

}  // namespace

TEST_CASE("The first pass that raises the mean moves vertices that no flip has touched, later ones few", "[improve]") {
  Model model = two_boxes(6);
  disturb_inside(model, 3);
  Bench bench(model);
  for (int pass = 0; pass < 20; ++pass) {  // flips alone, until none is left
    const RefineStatistics before = bench.statistics;
    RaisedBefore unused;
    raise_mean(bench.tools, 0, 0, {}, unused);
    REQUIRE(n_moved(unused) == 0);
    if (bench.statistics.edge_removals + bench.statistics.face_removals == before.edge_removals + before.face_removals)
      break;
    REQUIRE(pass < 19);
  }
  const double flipped = mean_worth(bench.mesh);
  RaisedBefore before;
  raise_mean(bench.tools, 0, 3, {}, before);
  const std::size_t n_first = n_moved(before);
  const double first = mean_worth(bench.mesh);
  CAPTURE(n_first, flipped, first);
  CHECK(n_first > 100);
  CHECK(first > flipped + 0.01);
  for (int pass = 0; pass < 3; ++pass) raise_mean(bench.tools, 0, 3, {}, before);
  CHECK(n_moved(before) < n_first);
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
    RaisedBefore unused;
    raise_mean(bench.tools, 0, 0, {}, unused);
    done.push_back(bench.statistics);
  }
  REQUIRE(done[0].edge_removals > 10);
  for (const RefineStatistics& other : done) CHECK(other.edge_removals == done[0].edge_removals);
}
