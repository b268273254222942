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
