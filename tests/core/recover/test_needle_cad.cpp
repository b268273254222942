// SPDX-License-Identifier: GPL-3.0-or-later
// Thin plates with many holes and posts, their flat parts fans of needle triangles, judged exactly.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <sstream>

#include "corpus_run.hpp"
#include "needle_cad.hpp"

using namespace geomesh;
using namespace geomesh::test;

namespace {

void mesh_plates(unsigned first, unsigned count) {
  for (unsigned seed = first; seed < first + count; ++seed) {
    const NeedleCadModel model = needle_cad(seed, needle_cad_options(seed));
    for (const bool keeps_boundary : {false, true}) {
      INFO("seed " << seed << (keeps_boundary ? ", boundary kept" : ""));
      const CorpusRun run = run_and_judge(model.plc, keeps_boundary ? preserving_mode() : constrained_mode(), 120);
      CHECK(run.trouble == "");
      if (!run.ok()) continue;
      CHECK(run.mesh->n_components == 1);
      const RecoveryStatistics& s = run.mesh->recovery;
      CHECK(20 * (s.steiner_on_segments + s.steiner_on_facets + s.steiner_inside) <= model.plc.points.size());
    }
  }
}

}  // namespace

TEST_CASE("the generator of needle plates makes valid closed solids with needles in fans", "[recover][needle-cad]") {
  double smallest = 180;
  for (unsigned seed = 0; seed < 12; ++seed) {
    INFO("seed " << seed);
    const NeedleCadModel model = needle_cad(seed, needle_cad_options(seed));
    CHECK(validate_plc(model.plc).empty());
    CHECK(model.volume > 0);
    CHECK(model.smallest_angle > 0);
    smallest = std::min(smallest, model.smallest_angle);
  }
  CHECK(smallest < 1e-3);
}

TEST_CASE("needle plates are meshed with few Steiner points, and none on the boundary where it is kept",
          "[recover][judged][needle-cad]") {
  mesh_plates(0, 6);
}

// GEOMESH_NEEDLE_CAD="FIRST COUNT" test_core "[needle-cad-seeds]": any range of seeds.
TEST_CASE("needle plates of the seeds asked for are meshed", "[recover][judged][.][needle-cad-seeds]") {
  const char* asked = std::getenv("GEOMESH_NEEDLE_CAD");
  REQUIRE(asked != nullptr);
  std::istringstream words(asked);
  unsigned first = 0, count = 0;
  REQUIRE(words >> first >> count);
  mesh_plates(first, count);
}

TEST_CASE("hundreds of needle plates are meshed", "[recover][judged][nightly][needle-cad]") { mesh_plates(1000, 300); }
