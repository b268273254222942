// SPDX-License-Identifier: MIT
// Contraction of edges: what is told of one vertex and all its neighbours at once is what each of them tells alone.
#include <algorithm>
#include <catch2/catch.hpp>

#include "common/sort_unique.hpp"
#include "refine_bench.hpp"

using namespace refine_models;

namespace {

constexpr double floor_of_shapes = 1e-3;

Model disturbed_ball() {
  Model model = ball_in_box(4);
  disturb_inside(model, 2);
  return model;
}

std::vector<VertexIndex> neighbours_of(Toolbox& tools, VertexIndex u) {
  std::vector<CellIndex> star;
  std::vector<VertexIndex> found;
  tools.mesh.star(u, tools.work.marks, star);
  for (const CellIndex c : star)
    for (const VertexIndex v : tools.mesh.vertices(c))
      if (v != u) found.push_back(v);
  sort_unique(found);
  return found;
}

/// Into the first neighbour that takes it, by an operation of its own for each.
bool collapse_one_by_one(Toolbox& tools, VertexIndex u, const std::vector<VertexIndex>& neighbours) {
  return std::ranges::any_of(
      neighbours, [&](VertexIndex v) { return try_collapse(tools, u, v, CollapseRule::coarsen, floor_of_shapes); });
}

std::vector<Tetrahedron> live_tetrahedra(const DomainMesh& mesh) {
  std::vector<Tetrahedron> found;
  for (const CellIndex c : mesh.live_cells()) found.push_back(mesh.vertices(c));
  return found;
}

}  // namespace

TEST_CASE("A vertex goes into the first neighbour that takes it, asked at once or one by one", "[improve]") {
  const double tolerance = GENERATE(0.0, 0.05);
  Bench at_once(disturbed_ball(), tolerance), one_by_one(disturbed_ball(), tolerance);
  std::size_t n_taken = 0, n_refused = 0;
  for (VertexIndex u = 0; u < at_once.mesh.points().size(); ++u) {
    if (at_once.mesh.kind(u) == VertexKind::dead) continue;
    const std::vector<VertexIndex> neighbours = neighbours_of(at_once.tools, u);
    const bool is_taken = try_collapse_into_any(at_once.tools, u, neighbours, CollapseRule::coarsen, floor_of_shapes);
    REQUIRE(is_taken == collapse_one_by_one(one_by_one.tools, u, neighbours));
    ++(is_taken ? n_taken : n_refused);
  }
  REQUIRE(n_taken > 0);
  REQUIRE(n_refused > 0);
  REQUIRE(at_once.mesh.validate() == "");
  REQUIRE(live_tetrahedra(at_once.mesh) == live_tetrahedra(one_by_one.mesh));
}

TEST_CASE("The star of a vertex, gathered step by step, is what a look at all cells tells", "[improve]") {
  Bench bench(disturbed_ball());
  const DomainMesh& mesh = bench.mesh;
  for (VertexIndex u = 0; u < mesh.points().size(); u += 3) {
    std::vector<CellIndex> star, expected;
    mesh.begin_star(u, bench.tools.work.marks, star);
    for (std::size_t k = 0; k < star.size(); ++k) mesh.grow_star(u, k, bench.tools.work.marks, star);
    for (const CellIndex c : mesh.live_cells())
      if (mesh.cells().has_vertex(c, u)) expected.push_back(c);
    std::ranges::sort(star);
    std::ranges::sort(expected);
    REQUIRE(star == expected);
  }
}

TEST_CASE("A star without a vertex has nothing that the vertex is part of, and all else", "[improve]") {
  Bench bench(disturbed_ball());
  const DomainMesh& mesh = bench.mesh;
  std::size_t n_spokes = 0, n_curves = 0;
  for (VertexIndex u = 0; u < mesh.points().size(); ++u)
    for (const VertexIndex v : neighbours_of(bench.tools, u)) {
      StarCavity all;
      gather_star(mesh, u, bench.tools.work.marks, all);
      StarCavity rest = all;
      drop_vertex(rest, v);
      CHECK(rest.cells == all.cells);
      for (const LinkFace& f : rest.link) CHECK(std::ranges::count(f.vertices, v) == 0);
      for (const Spoke& s : rest.spokes) CHECK((s.a != v && s.b != v));
      for (const CurveSpoke& s : rest.curves) CHECK(s.a != v);
      const auto with_v = std::ranges::count_if(all.cells, [&](CellIndex c) { return mesh.cells().has_vertex(c, v); });
      CHECK(all.link.size() - rest.link.size() == static_cast<std::size_t>(with_v));
      CHECK(all.curves.size() - rest.curves.size() == (mesh.curve_of(u, v) != no_index));
      n_spokes += all.spokes.size() - rest.spokes.size();
      n_curves += all.curves.size() - rest.curves.size();
    }
  CHECK(n_spokes > 0);
  CHECK(n_curves > 0);
}
