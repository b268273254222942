// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <functional>

#include "corpus_run.hpp"
#include "corpus_shared.hpp"
#include "corpus_transform.hpp"
#include "test_places.hpp"

using namespace geomesh;
using namespace geomesh::test;

namespace {

/// Every outside model that `wanted` names, in constrained mode and with the boundary kept, judged exactly.
void mesh_shared(const std::function<bool(const std::string&)>& wanted) {
  const std::vector<SharedModel> models = shared_models(GEOMESH_SHARED_DATA);
  if (models.empty()) WARN("skipped: no outside data in " GEOMESH_SHARED_DATA);
  for (const SharedModel& model : models) {
    if (!wanted(model.name)) continue;
    INFO(model.name);
    const PiecewiseLinearComplex plc = model.make();
    for (const TetrahedralizeOptions& options : {constrained_mode(), preserving_mode()}) {
      INFO((options.recover.preserve_boundary ? "boundary kept" : "constrained"));
      CHECK(run_and_judge(plc, options, 120).trouble == "");
    }
  }
}

bool is_any_of(const std::string& name, std::initializer_list<const char*> parts) {
  return std::any_of(parts.begin(), parts.end(),
                     [&](const char* part) { return name.find(part) != std::string::npos; });
}

}  // namespace

TEST_CASE("the hardest outside models are meshed, with and without points on their boundary",
          "[recover][judged][shared]") {
  mesh_shared([](const std::string& name) {
    return is_any_of(name, {"classic/", "tray", "plate_holes", "featuretype", "fixed_top", "round"});
  });
}
TEST_CASE("all outside models are meshed, with and without points on their boundary",
          "[recover][judged][shared][nightly]") {
  mesh_shared([](const std::string&) { return true; });
}
TEST_CASE("the solids together need few added points, and all outside models few tetrahedra", "[recover][shared]") {
  std::size_t n_points = 0, n_added = 0, n_triangles = 0, n_tetrahedra = 0;
  for (const SharedModel& model : shared_models(GEOMESH_SHARED_DATA)) {
    if (is_any_of(model.name, {"grains"})) continue;  // the hundred grains' box is nearly all tetrahedra between them
    const PiecewiseLinearComplex plc = model.make();
    const RecoveryStatistics s = tetrahedralize(plc).recovery;
    n_triangles += as_triangles(plc).n_facets();
    n_tetrahedra += s.tetrahedra_final;
    if (model.name.rfind("solids/", 0) != 0) continue;
    n_points += plc.points.size();
    n_added += s.steiner_on_segments + s.steiner_on_facets + s.steiner_inside;
  }
  INFO(n_added << " points added to " << n_points << " of the solids, " << n_tetrahedra << " tetrahedra of "
               << n_triangles << " triangles");
  CHECK(1000 * n_added <= n_points);
  CHECK(n_tetrahedra <= 3 * n_triangles);
}
