// SPDX-License-Identifier: GPL-3.0-or-later
// Faults that cross by noise in strips far narrower than their triangles, judged exactly.
#include <catch2/catch.hpp>

#include "judged_seeds.hpp"
#include "noisy_faults.hpp"

using namespace geomesh;
using namespace geomesh::geomodel::testing;

namespace {

void mesh_noisy_faults(unsigned first, unsigned count) {
  for (unsigned seed = first; seed < first + count; ++seed) {
    const NoisyFaultsModel model = noisy_faults_model(seed, noisy_faults_options(seed));
    INFO("seed " << seed);
    for (const TetrahedralizeOptions& options : {test::constrained_mode(), test::preserving_mode()})
      test::mesh_with_few_points(model.plc, options, 100, 120);
  }
}

}  // namespace

TEST_CASE("the generator of noisy faults makes strips that are far narrower than the triangles given",
          "[recover][noisy-faults]") {
  double narrowest = 1e9;
  for (unsigned seed = 0; seed < 4; ++seed) {
    INFO("seed " << seed);
    const NoisyFaultsModel model = noisy_faults_model(seed, noisy_faults_options(seed));
    CHECK(validate_plc(model.plc).empty());
    CHECK(model.plc.n_facets() > model.n_given / 4);
    narrowest = std::min(narrowest, model.narrowest);
  }
  CHECK(narrowest < 1e-3);
}

TEST_CASE("faults that cross by noise are meshed with at most one percent of Steiner points",
          "[recover][judged][noisy-faults]") {
  mesh_noisy_faults(0, 5);
}

// GEOMESH_NOISY_FAULTS="FIRST COUNT" test_geomodel "[noisy-faults-seeds]": any range of seeds.
TEST_CASE("noisy faults of the seeds asked for are meshed", "[recover][judged][.][noisy-faults-seeds]") {
  const std::vector<unsigned> asked = test::seeds_asked("GEOMESH_NOISY_FAULTS");
  mesh_noisy_faults(asked[0], asked[1]);
}

TEST_CASE("hundreds of models of noisy faults are meshed", "[recover][judged][nightly][noisy-faults]") {
  mesh_noisy_faults(1000, 200);
}
