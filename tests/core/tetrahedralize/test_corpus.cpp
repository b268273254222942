// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "corpus_run.hpp"

using namespace geomesh;
using namespace geomesh::test;

namespace {

void mesh_corpus(const TetrahedralizeOptions& options, bool large) {
  for (const CorpusModel& model : corpus_models()) {
    if (model.is_large != large) continue;
    INFO(model.name);
    const CorpusRun run = run_and_judge(model.make(), options, large ? 600 : 60);
    CHECK(run.trouble == "");
    if (run.ok()) CHECK(run.mesh->n_components == model.n_components);
  }
}

TetrahedralizeOptions conforming_mode_on_a_budget() {
  TetrahedralizeOptions options = conforming_mode();
  options.recover.max_steiner_per_facet = 100;
  return options;
}

}  // namespace

TEST_CASE("every hard model is meshed and passes the judge", "[judged][corpus]") {
  mesh_corpus(constrained_mode(), false);
}
TEST_CASE("every hard model is meshed with its boundary kept", "[judged][corpus]") {
  mesh_corpus(preserving_mode(), false);
}
TEST_CASE("every hard model is meshed in conforming mode", "[judged][corpus]") {
  mesh_corpus(conforming_mode_on_a_budget(), false);
}
TEST_CASE("every large hard model is meshed and passes the judge", "[judged][corpus][nightly]") {
  mesh_corpus(constrained_mode(), true);
}
TEST_CASE("every large hard model is meshed with its boundary kept", "[judged][corpus][nightly]") {
  mesh_corpus(preserving_mode(), true);
}

TEST_CASE("conforming mode leaves nothing of a lattice out", "[judged][corpus]") {
  const CorpusRun run = run_and_judge(corpus_model("cube_lattice_4").make(), conforming_mode());
  CHECK(run.trouble == "");
  REQUIRE(run.ok());
  CHECK(run.mesh->recovery.facets_not_recovered.empty());
  CHECK(run.mesh->delaunay);
}

TEST_CASE("Figure 2 of the paper comes out Delaunay", "[judged][corpus]") {
  const CorpusRun run = run_and_judge(corpus_model("high_degree_vertex").make(), conforming_mode());
  CHECK(run.trouble == "");
  REQUIRE(run.ok());
  CHECK(run.mesh->recovery.facets_not_recovered.empty());
  CHECK(run.mesh->delaunay);
  CHECK(run.mesh->recovery.steiner_on_segments > 0);
}
