// SPDX-License-Identifier: GPL-3.0-or-later
// Counts of the report that do not depend on numbering nor on the frame, on models without five cospherical points.
#include <catch2/catch.hpp>

#include "corpus_random.hpp"
#include "corpus_run.hpp"
#include "corpus_transform.hpp"

using namespace geomesh;
using namespace geomesh::test;

namespace {

struct Image {
  const char* name;
  PiecewiseLinearComplex plc;
  bool keeps_numbers;  ///< of vertices, and the order within loops
};

std::vector<Image> exact_images(const PiecewiseLinearComplex& plc) {
  return {{"shuffled", shuffled(plc, 11), false},
          {"axes permuted", mapped(plc, axes_permuted()), true},
          {"mirrored", mapped(plc, mirrored(), -1), false},
          {"scaled down", mapped(plc, scaled(-17)), true},
          {"scaled up", mapped(plc, scaled(23)), true}};
}

}  // namespace

TEST_CASE("what the Delaunay triangulation misses is the same in every exact image", "[recover][metamorphic]") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    INFO("seed " << seed);
    const PiecewiseLinearComplex plc = random_generic_plc(seed);
    const CorpusRun reference = run_and_judge(plc);
    CHECK(reference.trouble == "");
    if (!reference.ok()) continue;
    for (const Image& image : exact_images(plc)) {
      INFO(image.name);
      const CorpusRun run = run_and_judge(image.plc);
      CHECK(run.trouble == "");
      if (!run.ok()) continue;
      const RecoveryStatistics &a = run.mesh->recovery, &b = reference.mesh->recovery;
      CHECK(a.segments_total == b.segments_total);
      CHECK(a.facets_total == b.facets_total);
      CHECK(a.missing_edges_initial == b.missing_edges_initial);
      CHECK(a.missing_facets_before_segments == b.missing_facets_before_segments);
      CHECK(a.tetrahedra_unconstrained == b.tetrahedra_unconstrained);
      CHECK(run.mesh->n_components == reference.mesh->n_components);
    }
  }
}

TEST_CASE("flips and added points are as many in every exact image, cells and facets where numbers are kept", "[recover][metamorphic]") {
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    INFO("seed " << seed);
    const PiecewiseLinearComplex plc = random_generic_plc(seed);
    for (const TetrahedralizeOptions& options : {constrained_mode(), preserving_mode()}) {
      const RecoveryStatistics b = tetrahedralize(plc, options).recovery;
      for (const Image& image : exact_images(plc)) {
        INFO(image.name);
        const RecoveryStatistics a = tetrahedralize(image.plc, options).recovery;
        CHECK(a.edges_reinserted == b.edges_reinserted);
        CHECK(a.steiner_on_segments == b.steiner_on_segments);
        CHECK(a.steiner_on_facets == b.steiner_on_facets);
        CHECK(a.steiner_inside == b.steiner_inside);
        if (!image.keeps_numbers) continue;
        CHECK(a.facets_reinserted == b.facets_reinserted);
        CHECK(a.tetrahedra_final == b.tetrahedra_final);
      }
    }
  }
}
