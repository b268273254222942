// SPDX-License-Identifier: MIT
// Two surfaces that touch at points alone do not come to share an edge that no curve lists.
#include <catch2/catch.hpp>

#include "refine_bench.hpp"
#include "remesh/operations/improve.hpp"

using namespace geomesh;
using namespace geomesh::remesh;
using namespace refine_models;

namespace {

constexpr VertexIndex a = 8, b = 9, x = 10, y = 11, c = 12, d = 13;

/// In a box of side 4: two triangles with the long edge a-b, and above them, where `with_other`, two of another surface
/// with the short edge x-y. Flat enough to be remeshed; the cell between has both edges.
Model crossed_edges(bool with_other) {
  Model m;
  m.plc.points = {{-2, -2, -2}, {2, -2, -2}, {2, 2, -2}, {-2, 2, -2}, {-2, -2, 2},     {2, -2, 2},
                  {2, 2, 2},    {-2, 2, 2},  {-1, 0, 0}, {1, 0, 0},   {0, -0.3, 0.02}, {0, 0.3, 0.02}};
  if (with_other) m.plc.points.insert(m.plc.points.end(), {{-1, 0, 0.2}, {1, 0, 0.2}});
  Index surface = 0;
  for (const std::array<VertexIndex, 4>& s :
       {std::array<VertexIndex, 4>{0, 3, 2, 1}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}}) {
    m.plc.add_triangle({s[0], s[1], s[2]}, surface);
    m.plc.add_triangle({s[0], s[2], s[3]}, surface++);
  }
  m.plc.add_triangle({a, x, b}, surface);
  m.plc.add_triangle({a, b, y}, surface++);
  if (with_other) {
    m.plc.add_triangle({x, y, c}, surface);
    m.plc.add_triangle({y, x, d}, surface);
  }
  m.mesh = tetrahedralize(m.plc);
  return m;
}

/// Whether the edge a-b of the surface below is exchanged for x-y.
bool is_flipped(Bench& bench) {
  for (CellIndex cell = 0; cell < bench.mesh.n_slots(); ++cell)
    if (bench.mesh.is_live(cell) && bench.mesh.cells().has_vertex(cell, a) && bench.mesh.cells().has_vertex(cell, b))
      return flip_surface_edge(bench.tools, cell, a, b, 1e-6);
  FAIL("no cell has the edge");
  return false;
}

}  // namespace

TEST_CASE("A surface edge is flipped to where nothing is, and not to an edge of another surface", "[improve]") {
  Bench alone(crossed_edges(false), 0.1);
  CHECK(is_flipped(alone));
  CHECK(alone.mesh.validate() == "");
  Bench touching(crossed_edges(true), 0.1);
  CHECK_FALSE(is_flipped(touching));
  CHECK(touching.mesh.validate() == "");
}
