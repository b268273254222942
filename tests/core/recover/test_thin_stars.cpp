// SPDX-License-Identifier: GPL-3.0-or-later
// Added points whose stars are thinner than an ulp: their doubles are those that the lattice has in the star.
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

TEST_CASE("stars thinner than an ulp have no double near the places of their points", "[recover]") {
  for (ThinStar model : thin_stars()) {
    INFO(model.name);
    model.options.recover.max_attempts = recover::recovery_budget.attempts - 1;  // without the last one
    try {
      tetrahedralize(read(model), model.options);
      FAIL("the model has become too easy to test the search of all doubles");
    } catch (const Error& e) {
      CHECK(e.kind() == ErrorKind::cannot_mesh);
      CHECK(std::string(e.what()).find("no double") != std::string::npos);
    }
  }
}

TEST_CASE("stars thinner than an ulp get doubles elsewhere in them", "[recover][judged]") {
  for (const ThinStar& model : thin_stars()) {
    INFO(model.name);
    CHECK(run_and_judge(read(model), model.options).trouble == "");
  }
}
