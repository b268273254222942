// SPDX-License-Identifier: GPL-3.0-or-later
// Families whose recovery took time without bound: plates whose caps are triangulated by needles that cross each other.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "corpus_run.hpp"
#include "recovery_families.hpp"

using namespace geomesh;
using namespace geomesh::test;

namespace {

std::size_t n_added(const ConstrainedTetrahedralization& mesh) {
  std::size_t n = 0;
  for (const VertexIndex row : mesh.input_vertex) n += row == no_vertex;
  return n;
}

/// Returns the number of points added.
std::size_t check(const FamilyModel& model) {
  INFO(model.name);
  const CorpusRun run = run_and_judge(model.plc, constrained_mode());
  CHECK(run.trouble == "");
  if (!run.mesh) return 0;
  CHECK(std::fabs(volume_of(*run.mesh) / model.volume - 1) < 1e-9);
  return n_added(*run.mesh);
}

}  // namespace

TEST_CASE("plates of crossing needles are meshed with few points, flat and tilted, in layers",
          "[recover][judged][families]") {
  for (const CapTriangles triangles : {CapTriangles::turned_zigzag, CapTriangles::random_ears})
    for (const unsigned kind : {0u, 1u, 2u, 3u}) {
      PlateOptions options;
      options.n = 150;
      options.triangles = triangles;
      options.seed = kind;
      options.is_tilted = kind % 2;
      options.layers = 1 + kind / 2;
      CHECK(check(plate_of_needles(options)) <= 150 * (options.layers + 1) / 50);
    }
}

TEST_CASE("a thin plate whose caps are 3,000 needles each that cross each other is meshed",
          "[recover][judged][families]") {
  PlateOptions options;
  options.n = 3000;
  options.thickness = 0.001;
  const FamilyModel model = plate_of_needles(options);
  CHECK(check(model) <= model.plc.points.size() / 100);
}

TEST_CASE("a tenth of each family is meshed within its bounds", "[recover][judged][families]") {
  for (const ModelFamily& family : model_families())
    for (unsigned i = 2; i < 30; i += 6) {  // the larger ones take minutes: families_bench
      const FamilyModel model = family.make(i);
      const bool has_needles = family.name == "plates" || family.name == "fans";
      const std::size_t n_points = model.plc.points.size();
      CHECK(check(model) <= std::max<std::size_t>(1, has_needles ? n_points / 10 : n_points / 200));
    }
}

TEST_CASE("fans, sheets and lines of points are meshed", "[recover][judged][families]") {
  for (const FamilyModel& model :
       {crossing_fans(0, 100, 0.01), crossing_fans(1, 100, 0.001), flat_sheets(20, 4, 5e-5), points_on_line(5000)})
    CHECK(check(model) <= model.plc.points.size() / 200);
}
