// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cstdlib>
#include <sstream>

#include "corpus_run.hpp"
#include "structural_models.hpp"

using namespace geomesh;
using namespace geomesh::geomodel::testing;

namespace {

constexpr double time_limit = 120;  // seconds a model, many times what any takes

void mesh_structural_model(unsigned family, unsigned seed, const TetrahedralizeOptions& options) {
  INFO("family " << family << ", seed " << seed << (options.recover.preserve_boundary ? ", boundary kept" : ""));
  const StructuralModel model = structural_model(seed, structural_options(seed, family));
  const test::CorpusRun run = test::run_and_judge(model.plc, options, time_limit);
  CHECK(run.trouble == "");
  if (!run.ok()) return;
  const RecoveryStatistics& s = run.mesh->recovery;
  CHECK(100 * (s.steiner_on_segments + s.steiner_on_facets + s.steiner_inside) <= model.plc.points.size());
}

void mesh_structural_models(unsigned family, unsigned first, unsigned count) {
  for (unsigned seed = first; seed < first + count; ++seed) {
    mesh_structural_model(family, seed, test::constrained_mode());
    mesh_structural_model(family, seed, test::preserving_mode());
  }
}

}  // namespace

TEST_CASE("the generator of structural models makes needles in fans, down to the least height asked for",
          "[recover][structural]") {
  for (unsigned seed = 0; seed < 4; ++seed) {
    const StructuralModel model = structural_model(seed, structural_options(seed, 0));
    INFO("seed " << seed);
    CHECK(50 * model.n_needles >= model.plc.n_facets());  // at least 2 %
    CHECK(model.smallest_angle < 1e-2);
    CHECK(model.smallest_angle > 0);
    CHECK(model.least_height < 0.1);
    CHECK(validate_plc(model.plc).empty());
  }
}

// Each of these ended in dead ends again and again while Steiner points were rounded as they are made: seed 20 of the
// middle family needed more than twenty attempts.
TEST_CASE("sealed structural models with needles in fans are meshed with at most one percent of Steiner points",
          "[recover][judged][structural]") {
  mesh_structural_models(0, 0, 8);
  mesh_structural_models(1, 2, 4);
}

// GEOMESH_STRUCTURAL="FAMILY FIRST COUNT" test_geomodel "[structural-seeds]": any range of seeds.
TEST_CASE("structural models of the seeds asked for are meshed", "[recover][judged][.][structural-seeds]") {
  const char* asked = std::getenv("GEOMESH_STRUCTURAL");
  REQUIRE(asked != nullptr);
  std::istringstream words(asked);
  unsigned family = 0, first = 0, count = 0;
  REQUIRE(words >> family >> first >> count);
  REQUIRE(family < 3);
  mesh_structural_models(family, first, count);
}

TEST_CASE("a thousand structural models of three sizes are meshed", "[recover][judged][nightly][structural]") {
  mesh_structural_models(0, 1000, 600);
  mesh_structural_models(1, 1000, 300);
  mesh_structural_models(2, 1000, 100);
}
