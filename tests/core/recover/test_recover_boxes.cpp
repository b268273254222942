// SPDX-License-Identifier: GPL-3.0-or-later
// Random boxes (corpus_boxes.hpp), and what may not change a result.
#include <catch2/catch.hpp>

#include "corpus_boxes.hpp"
#include "corpus_run.hpp"
#include "corpus_transform.hpp"

using namespace geomesh;
using namespace geomesh::test;

TEST_CASE("random boxes are meshed", "[recover][judged][fuzz]") {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    INFO("seed " << seed);
    CHECK(run_and_judge(random_boxes(seed)).trouble == "");
  }
}

TEST_CASE("many random boxes are meshed in every mode", "[recover][judged][fuzz][nightly]") {
  const TetrahedralizeOptions modes[] = {conforming_mode(), preserving_mode(), constrained_mode(), constrained_mode(),
                                         constrained_mode()};
  for (std::uint64_t seed = 1001; seed <= 11000; ++seed) {
    INFO("seed " << seed);
    CHECK(run_and_judge(random_boxes(seed), modes[seed % 5]).trouble == "");
  }
}

TEST_CASE("what is missing at first is the same in every exact frame", "[recover][metamorphic]") {
  // Warped, so that no five points are cospherical.
  for (std::uint64_t seed = 301; seed < 321; ++seed) {
    INFO("seed " << seed);
    const PiecewiseLinearComplex model = random_boxes(seed);
    const auto reference = tetrahedralize(model), a = tetrahedralize(mapped(model, scaled(12))),
               b = tetrahedralize(mapped(model, axes_permuted()));
    CHECK(a.recovery.missing_edges_initial == reference.recovery.missing_edges_initial);
    CHECK(a.recovery.tetrahedra_unconstrained == reference.recovery.tetrahedra_unconstrained);
    CHECK(a.n_components == reference.n_components);
    CHECK(b.n_components == reference.n_components);
  }
}

TEST_CASE("the same input gives the same mesh", "[recover]") {
  const PiecewiseLinearComplex model = mapped(as_triangles(corpus_model("pinching_horizons").make()), turned());
  const auto a = tetrahedralize(model), b = tetrahedralize(model);
  CHECK(a.points == b.points);
  CHECK(a.tetrahedra == b.tetrahedra);
  CHECK(a.component == b.component);
}
