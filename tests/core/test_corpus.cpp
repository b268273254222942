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
    const CorpusRun run = run_and_judge(model.make(), options);
    CHECK(run.trouble == "");
    if (run.ok()) CHECK(run.mesh->n_components == model.n_components);
  }
}

}  // namespace

TEST_CASE("every hard model is meshed and passes the judge", "[judged]") { mesh_corpus(constrained_mode(), false); }
