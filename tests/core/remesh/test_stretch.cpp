// SPDX-License-Identifier: MIT
// Edges made longer by moving an end: what is promised holds, and what is refused has changed nothing.
#include <algorithm>
#include <catch2/catch.hpp>

#include "common/geometry.hpp"
#include "quality/measure/shape.hpp"
#include "refine_bench.hpp"
#include "remesh/operations/refine_ratios.hpp"
#include "remesh/rescue/rescue.hpp"

using namespace geomesh;
using namespace geomesh::remesh;
using namespace refine_models;

namespace {

double worst_about(const DomainMesh& mesh, VertexIndex v) {
  double worst = 1;
  for (const CellIndex c : mesh.live_cells())
    if (mesh.cells().has_vertex(c, v)) worst = std::min(worst, mesh.shape_of(c));
  return worst;
}

double worst_of(const DomainMesh& mesh) {
  double worst = 1;
  for (const CellIndex c : mesh.live_cells()) worst = std::min(worst, mesh.shape_of(c));
  return worst;
}

}  // namespace

TEST_CASE("A stretched edge is as long as asked, no cell is worse than the floor, and no other edge becomes short",
          "[stretch]") {
  Bench bench(ball_in_box(4));
  DomainMesh& mesh = bench.mesh;
  const double floor = DihedralMeasure::of_angle(10);
  std::size_t n_moved = 0, n_refused = 0;
  for (CellIndex c = 0; c < mesh.n_slots(); ++c) {
    if (!mesh.is_live(c)) continue;
    const Tetrahedron t = mesh.vertices(c);
    const DomainMesh copy = mesh;
    const double before = worst_about(mesh, t[0]), length = 1.15 * distance(mesh.point(t[0]), mesh.point(t[1]));
    if (try_stretch(bench.tools, t[0], t[1], length, floor)) {
      ++n_moved;
      CHECK(distance(mesh.point(t[0]), mesh.point(t[1])) >= 0.98 * length);
      CHECK(mesh.kind(t[0]) != VertexKind::corner);
      CHECK(worst_about(mesh, t[0]) >= 0.99 * std::min(before, floor));
      for (VertexIndex x = 0; x < mesh.n_vertices(); ++x)
        if (x != t[0]) CHECK(mesh.point(x) == copy.point(x));
      mesh = copy;
    } else {
      ++n_refused;
      CHECK(mesh.point(t[0]) == copy.point(t[0]));
    }
    REQUIRE(mesh.validate() == "");
  }
  CHECK(n_moved > 0);
  CHECK(n_refused > 0);
}

TEST_CASE("A stretch that is mended leaves no cell worse than the worst or the rule", "[stretch]") {
  Bench bench(ball_in_box(4));
  DomainMesh& mesh = bench.mesh;
  const RescueRule rule{DihedralMeasure::of_angle(20), 12, 30};
  std::size_t n_kept = 0;
  for (CellIndex c = 0; c < mesh.n_slots(); c += 3) {
    if (!mesh.is_live(c)) continue;
    const Tetrahedron t = mesh.vertices(c);
    const double before = worst_of(mesh), length = 1.3 * distance(mesh.point(t[0]), mesh.point(t[1]));
    n_kept += stretch_mending(bench.tools, t[0], t[1], length, rule);
    CHECK(worst_of(mesh) >= std::min(before, rule.bad_shape));
    REQUIRE(mesh.validate() == "");
  }
  CHECK(n_kept > 0);
}
