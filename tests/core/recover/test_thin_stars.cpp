// SPDX-License-Identifier: GPL-3.0-or-later
// Added points whose stars are thinner than an ulp: their doubles are those that the lattice has in the star. All five
// models are refused ("no double near") where round_steiner_points does not look for these.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "corpus_run.hpp"
#include "plc_reader.hpp"
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

TEST_CASE("stars thinner than an ulp get doubles elsewhere in them", "[recover][judged]") {
  for (const ThinStar& model : thin_stars()) {
    INFO(model.name);
    CHECK(run_and_judge(read(model), model.options).trouble == "");
  }
}
