// SPDX-License-Identifier: GPL-3.0-or-later
// Networks of discs hold thousands of places where facets meet at small angles. One of them must not make recovery
// begin again with the whole model, because the number of attempts would then grow with the model.
#include <catch2/catch.hpp>
#include <cmath>
#include <string_view>

#include "corpus_run.hpp"
#include "disc_network.hpp"

using namespace geomesh;

TEST_CASE("networks of discs in which rounded points would end in a cascade are recovered in one attempt",
          "[fractures][judged][families]") {
  for (const unsigned seed : {2u, 3u}) {
    const test::FamilyModel model = geomodel::testing::disc_network(seed, 80);
    INFO(model.name);
    unsigned n_ended = 0;
    RunContext watch;
    watch.log = [&](LogLevel, std::string_view text) { n_ended += text.substr(0, 8) == "attempt "; };
    const test::CorpusRun run = test::run_and_judge(model.plc, test::constrained_mode(), 60, watch);
    CHECK(run.trouble == "");
    CHECK(n_ended == 0);
    if (!run.mesh) continue;
    CHECK(std::fabs(test::volume_of(*run.mesh) / model.volume - 1) < 1e-9);
    std::size_t n_added = 0;
    for (const VertexIndex row : run.mesh->input_vertex) n_added += row == no_vertex;
    CHECK(200 * n_added <= model.plc.points.size());
  }
}
