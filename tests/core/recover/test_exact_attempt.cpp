// SPDX-License-Identifier: GPL-3.0-or-later
// What the exact attempt is for: fans of needles, on which points that are rounded as they are made crowd without end.
#include <catch2/catch.hpp>
#include <string_view>

#include "corpus_run.hpp"
#include "plc_reader.hpp"
#include "test_places.hpp"

using namespace geomesh;
using namespace geomesh::test;

namespace {

PiecewiseLinearComplex needle_cascade() {
  return read_plc(GEOMESH_SOURCE_DIR "/tests/corpus/needle_cascade/needle_cascade.poly");
}

/// Counts the attempts at recovery that end without a mesh.
RunContext counting(unsigned& n_ended) {
  RunContext out;
  out.log = [&n_ended](LogLevel, std::string_view text) { n_ended += text.substr(0, 8) == "attempt "; };
  return out;
}

}  // namespace

TEST_CASE("a fan of needles where rounded points end in a dead end is refused if no second attempt is allowed",
          "[recover]") {
  TetrahedralizeOptions options;
  options.recover.max_attempts = 1;
  try {
    tetrahedralize(needle_cascade(), options);
    FAIL("the model has become too easy to test the exact attempt");
  } catch (const Error& e) {
    CHECK(e.kind() == ErrorKind::cannot_mesh);
    CHECK(!e.context().places.empty());
    CHECK(!e.context().facets.empty());
  }
}

TEST_CASE("a fan of needles where rounded points end in a dead end is meshed by exact points at once",
          "[recover][judged]") {
  const PiecewiseLinearComplex plc = needle_cascade();
  for (const TetrahedralizeOptions& options : {constrained_mode(), preserving_mode()}) {
    INFO((options.recover.preserve_boundary ? "boundary kept" : "constrained"));
    unsigned n_ended = 0;
    const CorpusRun run = run_and_judge(plc, options, 60, counting(n_ended));
    CHECK(run.trouble == "");
    CHECK(n_ended == 0);
    if (!run.ok()) continue;
    const RecoveryStatistics& s = run.mesh->recovery;
    CHECK(100 * (s.steiner_on_segments + s.steiner_on_facets + s.steiner_inside) <= plc.points.size());
  }
}

TEST_CASE("conforming mode on a fan of needles ends with a mesh and lists the facets that are not Delaunay",
          "[recover][judged]") {
  const CorpusRun run = run_and_judge(needle_cascade(), conforming_mode());
  CHECK(run.trouble == "");
  REQUIRE(run.ok());
  CHECK((run.mesh->delaunay || !run.mesh->recovery.facets_not_recovered.empty()));
}
