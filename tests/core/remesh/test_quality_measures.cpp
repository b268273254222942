// SPDX-License-Identifier: MIT
// Improvement by each quality measure: what its least value, and that of the others, comes to on generated models.
#include <catch2/catch.hpp>
#include <cstdio>

#include "geomesh/core/refine.hpp"
#include "quality/measure/cell_quality.hpp"
#include "quality_measures.hpp"
#include "refine_models.hpp"

using namespace geomesh;
using namespace geomesh::remesh;
using geomesh::test::all_measures;
using namespace refine_models;

namespace {

struct Case {
  const char* name;
  Model model;
  double size;
};

std::vector<Case> cases() {
  return {{"two boxes", two_boxes(3), 0.12},
          {"ball in a box", ball_in_box(5), 0.5},
          {"box with a well", box_with_well(4), 0.12},
          {"box with a ridge", box_with_ridge(0.5), 0.5}};
}

RefineResult improve_by(const Case& c, QualityMeasure measure) {
  RefineOptions options;
  options.size.global = c.size;
  options.quality_measure = measure;
  return refine_and_improve(c.model.plc, c.model.mesh, options);
}

double least(const ConstrainedTetrahedralization& mesh, QualityMeasure measure) {
  const CellQuality quality(measure);
  double least = 1;
  for (const Tetrahedron& t : mesh.tetrahedra)
    least = std::min(least, quality.shape(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]));
  return least;
}

}  // namespace

TEST_CASE("Improvement by each quality measure raises its least value", "[improve]") {
  for (const Case& c : cases())
    for (const QualityMeasure measure : all_measures) {
      CAPTURE(c.name, name_of(measure));
      const RefineResult r = improve_by(c, measure);
      CHECK(r.statistics.quality_measure == measure);
      CHECK(r.statistics.worst_shape_after == Approx(least(r.mesh, measure)));  // corners in another order
      CHECK(r.statistics.worst_shape_after > r.statistics.worst_shape_before);
      CHECK(r.statistics.worst_shape_after > CellQuality(measure).of_angle(12));
    }
}

TEST_CASE("A table of least values of each quality measure after improvement by each", "[.][measures]") {
  std::printf("| model | improved by | cells |");
  for (const QualityMeasure m : all_measures) std::printf(" least %s |", name_of(m).data());
  std::printf("\n|---|---|---|---|---|---|\n");
  for (const Case& c : cases())
    for (const QualityMeasure by : all_measures) {
      const RefineResult r = improve_by(c, by);
      std::printf("| %s | %s | %zu |", c.name, name_of(by).data(), r.mesh.tetrahedra.size());
      for (const QualityMeasure m : all_measures) std::printf(" %.3f |", least(r.mesh, m));
      std::printf("\n");
    }
}
