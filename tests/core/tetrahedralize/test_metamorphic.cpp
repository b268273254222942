// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "corpus_run.hpp"
#include "corpus_transform.hpp"

using namespace geomesh;
using namespace geomesh::test;

namespace {

/// In constrained mode, and with the boundary kept. `needs_room`: leaves out what UTM coordinates round to a few ulps.
void mesh_all(const std::function<PiecewiseLinearComplex(const PiecewiseLinearComplex&)>& image,
              bool needs_room = false) {
  for (const CorpusModel& model : corpus_models()) {
    if (model.is_large || (needs_room && !model.fits_utm)) continue;
    INFO(model.name);
    const PiecewiseLinearComplex plc = image(model.make());
    for (const TetrahedralizeOptions& options : {constrained_mode(), preserving_mode()}) {
      INFO((options.recover.preserve_boundary ? "boundary kept" : "constrained"));
      const CorpusRun run = run_and_judge(plc, options);
      CHECK(run.trouble == "");
      if (run.ok()) CHECK(run.mesh->n_components == model.n_components);
    }
  }
}

}  // namespace

TEST_CASE("the hard models are meshed whatever the order of vertices and facets", "[judged][metamorphic]") {
  mesh_all([](const auto& plc) { return shuffled(plc, 7); });
}
TEST_CASE("the hard models are meshed with its axes permuted", "[judged][metamorphic]") {
  mesh_all([](const auto& plc) { return mapped(plc, axes_permuted()); });
}
TEST_CASE("the hard models are meshed mirrored", "[judged][metamorphic]") {
  mesh_all([](const auto& plc) { return mapped(plc, mirrored(), -1); });
}
TEST_CASE("the hard models are meshed scaled by powers of two", "[judged][metamorphic]") {
  mesh_all([](const auto& plc) { return mapped(plc, scaled(-20)); });
  mesh_all([](const auto& plc) { return mapped(plc, scaled(31)); });
}
TEST_CASE("the hard models are meshed as triangles turned by odd angles", "[judged][metamorphic]") {
  mesh_all([](const auto& plc) { return mapped(as_triangles(plc), turned()); });
}
TEST_CASE("the hard models are meshed as triangles in UTM coordinates", "[judged][metamorphic]") {
  mesh_all([](const auto& plc) { return mapped(as_triangles(plc), moved_to_utm()); }, true);
}
TEST_CASE("the hard models are meshed as triangles turned and in UTM coordinates", "[judged][metamorphic]") {
  mesh_all([](const auto& plc) { return mapped(mapped(as_triangles(plc), turned()), moved_to_utm()); }, true);
}
TEST_CASE("the hard models are meshed as given turned by odd angles, so that polygons are bent",
          "[judged][metamorphic]") {
  mesh_all([](const auto& plc) { return mapped(plc, turned()); }, true);
}
TEST_CASE("the hard models are meshed as given in UTM coordinates", "[judged][metamorphic]") {
  mesh_all([](const auto& plc) { return mapped(plc, moved_to_utm()); }, true);
}
TEST_CASE("the hard models are meshed flattened", "[judged][metamorphic]") {
  mesh_all([](const auto& plc) { return mapped(as_triangles(plc), flattened(1e-4)); }, true);
}
