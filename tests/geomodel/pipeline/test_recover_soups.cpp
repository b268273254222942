// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "judged_seeds.hpp"
#include "soup_models.hpp"
#include "test_places.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;

namespace {

void mesh_soups(unsigned first, unsigned count) {
  for (unsigned seed = first; seed < first + count; ++seed) {
    INFO("seed " << seed);
    const PiecewiseLinearComplex model = random_model(seed);
    for (const TetrahedralizeOptions& options : {test::constrained_mode(), test::preserving_mode()}) {
      INFO((options.recover.preserve_boundary ? "boundary kept" : "constrained"));
      CHECK(test::run_and_judge(model, options, 60).trouble == "");
    }
  }
}

/// Both ways of constrained mode, judged; hardly any points are added.
void mesh_in_both_ways(const PiecewiseLinearComplex& model, double time_limit) {
  for (const TetrahedralizeOptions& options : {test::constrained_mode(), test::preserving_mode()}) {
    const test::CorpusRun run = test::mesh_with_few_points(model, options, 100, time_limit);
    if (run.ok()) CHECK(run.mesh->tetrahedra.size() <= 4 * model.n_facets());
  }
}

void mesh_crossed_walls(unsigned first, unsigned count) {
  for (unsigned seed = first; seed < first + count; ++seed) {
    INFO("seed " << seed);
    mesh_in_both_ways(crossed_wall(seed, 12), 60);
  }
}

void mesh_faults(const std::string& group) {
  const std::string folder = std::string(GEOMESH_SHARED_DATA) + "/faults/" + group;
  if (!std::filesystem::exists(folder)) {
    WARN("skipped: no outside data in " << folder);
    return;
  }
  mesh_in_both_ways(faults_in_box(folder), 120);
}

}  // namespace

TEST_CASE("random soups that the arrangement made valid are meshed, with and without points on their boundary",
          "[recover][judged]") {
  mesh_soups(0, 200);
  mesh_soups(7944, 1);  // needs nine attempts with its boundary kept
}
// GEOMESH_SOUPS="FIRST COUNT" test_geomodel "[soups]": any range of seeds, to share a long run among processes or to
// come back to one.
TEST_CASE("random soups of the seeds asked for are meshed", "[recover][judged][.][soups]") {
  const std::vector<unsigned> asked = test::seeds_asked("GEOMESH_SOUPS");
  mesh_soups(asked[0], asked[1]);
}
TEST_CASE("ten thousand random soups are meshed", "[recover][judged][nightly]") { mesh_soups(1000, 10000); }
TEST_CASE("plates in odd planes with many bodies across a wall are meshed", "[recover][judged]") {
  mesh_crossed_walls(1, 8);
}
TEST_CASE("a hundred plates in odd planes with many bodies across a wall are meshed", "[recover][judged][nightly]") {
  mesh_crossed_walls(100, 100);
}
TEST_CASE("the outside solid that crosses itself along two plane walls is meshed", "[recover][judged][shared]") {
  const std::filesystem::path file = std::filesystem::path(GEOMESH_SHARED_DATA) / "solids/Gravgen.obj";
  if (!std::filesystem::exists(file)) {
    WARN("skipped: no outside data in " << file);
    return;
  }
  const TriangulatedSurface solid = load_obj(file);
  ArrangementOptions in_box;
  in_box.box = wide_box({solid});
  for (const ArrangementOptions& options : {ArrangementOptions{}, in_box}) {
    INFO((options.box ? "in a box" : "without a box"));
    mesh_in_both_ways(complex_of(arrange({solid}, {}, {}, options).soup), 120);
  }
}
TEST_CASE("the intersected faults of a salt diapir are meshed", "[recover][judged][shared]") { mesh_faults("SALT"); }
TEST_CASE("the intersected faults of MJVA are meshed", "[recover][judged][shared]") { mesh_faults("MJVA"); }
TEST_CASE("the intersected faults of SNFA are meshed", "[recover][judged][shared]") { mesh_faults("SNFA"); }
