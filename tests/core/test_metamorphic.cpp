// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "corpus_run.hpp"
#include "corpus_transform.hpp"

using namespace geomesh;
using namespace geomesh::test;

namespace {

void mesh_all(const std::function<PiecewiseLinearComplex(const PiecewiseLinearComplex&)>& image) {
  for (const CorpusModel& model : corpus_models()) {
    if (model.is_large) continue;
    INFO(model.name);
    const CorpusRun run = run_and_judge(image(model.make()));
    CHECK(run.trouble == "");
    if (run.ok()) CHECK(run.mesh->n_components == model.n_components);
  }
}

}  // namespace

TEST_CASE("the hard models are meshed with its axes permuted", "[judged][metamorphic]") {
  mesh_all([](const auto& plc) { return mapped(plc, axes_permuted()); });
}
TEST_CASE("the hard models are meshed mirrored", "[judged][metamorphic]") {
  mesh_all([](const auto& plc) { return mapped(plc, mirrored(), -1); });
}
