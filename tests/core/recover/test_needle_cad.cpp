// SPDX-License-Identifier: GPL-3.0-or-later
// Thin plates with many holes and posts, their flat parts fans of needle triangles, judged exactly.
#include <catch2/catch.hpp>

#include "judged_seeds.hpp"
#include "needle_cad.hpp"

using namespace geomesh;
using namespace geomesh::test;

namespace {

void mesh_plates(unsigned first, unsigned count) {
  for (unsigned seed = first; seed < first + count; ++seed) {
    const NeedleCadModel model = needle_cad(seed, needle_cad_options(seed));
    INFO("seed " << seed);
    for (const TetrahedralizeOptions& options : {constrained_mode(), preserving_mode()}) {
      const CorpusRun run = mesh_with_few_points(model.plc, options, 20, 120);
      if (run.ok()) CHECK(run.mesh->n_components == 1);
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
  const std::vector<unsigned> asked = test::seeds_asked("GEOMESH_NEEDLE_CAD");
  mesh_plates(asked[0], asked[1]);
}

TEST_CASE("hundreds of needle plates are meshed", "[recover][judged][nightly][needle-cad]") { mesh_plates(1000, 300); }
