// SPDX-License-Identifier: MIT
// Models of which parts touch at edges and vertices alone.
#include <catch2/catch.hpp>

#include "refine_bench.hpp"
#include "remesh/operations/improve.hpp"

using namespace geomesh;
using namespace geomesh::remesh;
using namespace refine_models;

TEST_CASE("Where cells meet with the outside between, nothing changes that has cells on both sides", "[improve]") {
  for (const double tolerance : {0.0, 0.05}) {
    Bench bench(blocks_at_an_edge(3), tolerance);
    const auto is_in_middle = [&](VertexIndex v) {
      return bench.mesh.point(v).x == 0.5 && bench.mesh.point(v).y == 0.5;
    };
    std::vector<std::array<VertexIndex, 2>> line;
    for (const auto& e : bench.mesh.curve_edges())
      if (is_in_middle(e[0]) && is_in_middle(e[1])) line.push_back(e);
    CHECK(line.size() == 6);
    for (VertexIndex v = 0; v < bench.mesh.n_vertices(); ++v) {
      CHECK(bench.mesh.is_pinched(v) == is_in_middle(v));
      if (is_in_middle(v)) CHECK(bench.mesh.kind(v) == VertexKind::corner);
    }
    for (CellIndex c = 0; c < bench.mesh.n_slots(); ++c)
      for (const auto& [a, b] : line) {
        if (!bench.mesh.cells().has_vertex(c, a) || !bench.mesh.cells().has_vertex(c, b)) continue;
        CHECK_FALSE(split_edge(bench.tools, c, a, b).has_value());
        CHECK_FALSE(split_to_improve(bench.tools, c, a, b));
      }
    const double before = bench.volume();
    for (unsigned e = 0; e < 6; ++e) {
      const auto ends = [e](Bench& b, CellIndex c) {
        const Tetrahedron& t = b.mesh.vertices(c);
        return std::array{t[edge_vertices[e][0]], t[edge_vertices[e][1]]};
      };
      over_cells(bench, 3, [&](Bench& b, CellIndex c) {
        return split_edge(b.tools, c, ends(b, c)[0], ends(b, c)[1]).has_value();
      });
      over_cells(bench, 3, [&](Bench& b, CellIndex c) {
        return try_collapse(b.tools, ends(b, c)[0], ends(b, c)[1], CollapseRule::coarsen, 1e-3);
      });
      over_cells(bench, 3, [&](Bench& b, CellIndex c) {
        return remove_edge_above(b.tools, c, ends(b, c)[0], ends(b, c)[1], 1e-3);
      });
    }
    CHECK(bench.statistics.collapses > 0);
    CHECK(bench.volume() == Approx(before));
    // Every edge on the line still is one of cells in both blocks.
    for (const auto& [a, b] : line) {
      std::array<bool, 2> is_met{};
      for (CellIndex c = 0; c < bench.mesh.n_slots(); ++c)
        if (bench.mesh.is_live(c) && bench.mesh.cells().has_vertex(c, a) && bench.mesh.cells().has_vertex(c, b)) {
          double x = 0;
          for (const VertexIndex v : bench.mesh.vertices(c)) x += bench.mesh.point(v).x;
          is_met[x < 2 ? 0 : 1] = true;
        }
      CHECK((is_met[0] && is_met[1]));
    }
  }
}

TEST_CASE("A curve that touches a side at one vertex stays there", "[refine]") {
  // Found by seed 1002612 of the random models (--light): the vertex moved along the curve, and made a dent in the
  // side.
  PiecewiseLinearComplex plc;
  plc.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const std::vector<std::array<VertexIndex, 4>> sides{
      {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}};
  for (Index s = 0; s < sides.size(); ++s) {
    plc.add_triangle({sides[s][0], sides[s][1], sides[s][2]}, s);
    plc.add_triangle({sides[s][0], sides[s][2], sides[s][3]}, s);
  }
  const std::array<VertexIndex, 4> left{0, 4, 7, 3};
  const VertexIndex touching = 8;
  plc.points.push_back({0, 0.5, 0.5});
  for (std::size_t k = 0; k < 4; ++k) plc.add_triangle({left[k], left[(k + 1) % 4], touching}, 5);
  for (const Vec3& p : {Vec3{0.02, 0.3, 0.5}, Vec3{0.02, 0.7, 0.5}, Vec3{0.8, 0.5, 0.5}}) plc.points.push_back(p);
  plc.add_triangle({9, touching, 11}, 6);
  plc.add_triangle({touching, 10, 11}, 6);
  Model model{plc, tetrahedralize(plc, {})};
  Bench bench(std::move(model), 0.05);
  for (VertexIndex v = 0; v < bench.mesh.n_vertices(); ++v)
    if (bench.mesh.point(v) == plc.points[touching]) CHECK(bench.mesh.kind(v) == VertexKind::corner);
  over_cells(bench, 1, [&](Bench& b, CellIndex c) {
    bool moved = false;
    for (const VertexIndex v : b.mesh.vertices(c)) moved = smooth_vertex(b.tools, v, {}) || moved;
    return moved;
  });
  CHECK(bench.volume() == Approx(1).epsilon(1e-12));
}
