// SPDX-License-Identifier: GPL-3.0-or-later
// Added points whose stars are thinner than an ulp. As doubles from the moment they were made they ended in a cascade,
// and only the search of all doubles of their stars ended it; made again exactly, they have doubles near their places.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "corpus_run.hpp"
#include "plc_reader.hpp"
#include "recover/model/recovery_budget.hpp"
#include "test_places.hpp"

using namespace geomesh;
using namespace geomesh::test;

namespace {

struct ThinStar {
  const char* name;
  TetrahedralizeOptions options;
};

PiecewiseLinearComplex read(const ThinStar& model) {
  return read_plc(std::string(GEOMESH_SOURCE_DIR "/tests/corpus/thin_stars/") + model.name + ".poly");
}

std::vector<ThinStar> thin_stars() {
  return {{"seed_200084", constrained_mode()},
          {"seed_20144", constrained_mode()},
          {"seed_100009", constrained_mode()},
          {"seed_100052", constrained_mode()},
          {"seed_20007", preserving_mode()}};
}

}  // namespace

TEST_CASE("points with stars thinner than an ulp are made so that they have doubles near their places",
          "[recover][judged]") {
  for (ThinStar model : thin_stars()) {
    INFO(model.name);
    model.options.recover.max_attempts = recover::recovery_budget.attempts - 1;  // without the search of all doubles
    CHECK(run_and_judge(read(model), model.options).trouble == "");
  }
}
