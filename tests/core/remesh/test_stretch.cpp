// SPDX-License-Identifier: MIT
// Edges made longer by moving an end: what is promised holds, and what is refused has changed nothing.
#include <algorithm>
#include <catch2/catch.hpp>

#include "common/geometry.hpp"
#include "quality/measure/shape.hpp"
#include "refine_bench.hpp"
#include "remesh/operations/refine_ratios.hpp"
#include "remesh/rescue/rescue.hpp"

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

/// Edges below the promised share of the size.
std::vector<std::array<VertexIndex, 2>> short_edges_of(Toolbox& tools) {
  std::vector<std::array<VertexIndex, 2>> found;
  for (const CellIndex c : tools.mesh.live_cells()) {
    const Tetrahedron& t = tools.mesh.vertices(c);
    for (const auto& e : edge_vertices) {
      std::array<VertexIndex, 2> edge{std::min(t[e[0]], t[e[1]]), std::max(t[e[0]], t[e[1]])};
      const double least = tools.lengths.absolute(edge[0], edge[1], refine_ratios.promised_edge);
      if (distance(tools.mesh.point(edge[0]), tools.mesh.point(edge[1])) < least) found.push_back(edge);
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// A disturbed ball in a box whose shortest edges are just below what is promised.
struct ShortBench {
  static SizeField uniform(double size) {
    SizeField::Limits limits;
    limits.global = size;
    return SizeField({}, limits);
  }
  explicit ShortBench(double tolerance = 0)
      : bench(disturbed(), tolerance),
        size(uniform(just_above_shortest())),
        tools(bench.mesh, bench.guard, size, bench.statistics) {}
  static Model disturbed() {
    Model model = ball_in_box(4);
    disturb_inside(model, 2);
    return model;
  }
  /// The size whose promised share is the length of the twentieth edge by length.
  double just_above_shortest() const {
    std::vector<double> lengths;
    const DomainMesh& mesh = bench.mesh;
    for (const CellIndex c : mesh.live_cells())
      for (const auto& e : edge_vertices)
        lengths.push_back(distance(mesh.point(mesh.vertices(c)[e[0]]), mesh.point(mesh.vertices(c)[e[1]])));
    std::sort(lengths.begin(), lengths.end());
    return lengths.at(60) / refine_ratios.promised_edge;
  }
  Bench bench;
  SizeField size;
  Toolbox tools;
};

}  // namespace

TEST_CASE("A stretched edge is as long as asked, and no other edge becomes short", "[improve]") {
  ShortBench b(0.05);
  DomainMesh& mesh = b.bench.mesh;
  const double floor = mesh.measure().of_angle(1);
  const auto edges = short_edges_of(b.tools);
  REQUIRE(edges.size() > 5);
  std::size_t n_moved = 0, n_refused = 0;
  for (const auto& edge : edges)
    for (const bool turned : {false, true}) {
      const VertexIndex u = edge[turned], v = edge[!turned];
      const DomainMesh copy = mesh;
      const double before = worst_about(mesh, u);
      const double length = b.tools.lengths.absolute(u, v, refine_ratios.stretched_edge);
      const auto was_short = short_edges_of(b.tools);
      if (!std::ranges::binary_search(was_short, edge)) continue;  // a move before this one has mended it
      if (try_stretch(b.tools, u, v, length, floor)) {
        ++n_moved;
        CHECK(distance(mesh.point(u), mesh.point(v)) >= 0.98 * length);
        CHECK(mesh.kind(u) != VertexKind::corner);
        CHECK(worst_about(mesh, u) >= 0.99 * std::min(before, floor));
        const auto is_short = short_edges_of(b.tools);
        CHECK(is_short.size() < was_short.size());
        CHECK(std::ranges::includes(was_short, is_short));
        for (VertexIndex x = 0; x < mesh.n_vertices(); ++x)
          if (x != u) CHECK(mesh.point(x) == copy.point(x));
      } else {
        ++n_refused;
        CHECK(mesh.point(u) == copy.point(u));
      }
      REQUIRE(mesh.validate() == "");
    }
  CHECK(n_moved > 0);
  CHECK(n_refused > 0);
}

TEST_CASE("With surfaces kept exactly no vertex on a surface is moved to stretch an edge", "[improve]") {
  ShortBench b;
  DomainMesh& mesh = b.bench.mesh;
  std::size_t n_on_surfaces = 0;
  for (const CellIndex c : mesh.live_cells())
    for (const auto& e : edge_vertices) {
      const VertexIndex u = mesh.vertices(c)[e[0]], v = mesh.vertices(c)[e[1]];
      if (mesh.kind(u) == VertexKind::inside) continue;
      ++n_on_surfaces;
      CHECK_FALSE(try_stretch(b.tools, u, v, 1.01 * distance(mesh.point(u), mesh.point(v)), 0));
    }
  CHECK(n_on_surfaces > 0);
}

TEST_CASE("A stretch that is mended leaves no cell worse than the worst or the rule", "[improve]") {
  ShortBench b(0.05);
  DomainMesh& mesh = b.bench.mesh;
  const RescueRule rule{mesh.measure().of_angle(20), 12, 30};
  std::size_t n_kept = 0;
  for (const auto& [u, v] : short_edges_of(b.tools)) {
    const double before = worst_of(mesh), length = b.tools.lengths.absolute(u, v, refine_ratios.stretched_edge);
    n_kept += stretch_mending(b.tools, u, v, length, rule) || stretch_mending(b.tools, v, u, length, rule);
    CHECK(worst_of(mesh) >= std::min(before, rule.bad_shape));
    REQUIRE(mesh.validate() == "");
  }
  CHECK(n_kept > 0);
}
