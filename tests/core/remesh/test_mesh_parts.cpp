// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "refine_bench.hpp"
#include "remesh/domain/domain_mesh.hpp"
#include "remesh/passes/passes.hpp"

using namespace refine_models;

namespace {

std::size_t n_constrained(const DomainMesh& mesh) {
  std::size_t n = 0;
  for (CellIndex c = 0; c < mesh.n_slots(); ++c)
    for (unsigned i = 0; i < 4; ++i) n += mesh.is_live(c) && mesh.tag(c, i).constrained();
  return n;
}

/// Two boxes of cubes of 0.125, asked for 0.1.
struct ToRefine {
  Bench bench{two_boxes(4)};
  ToRefine() {
    SizeField::Limits limits;
    limits.global = 0.1;
    bench.size = SizeField({}, limits);
  }
  std::size_t refine(unsigned threads, std::size_t most_cells = 1'000'000) {
    RunContext context;
    context.threads = threads;
    return refine_components_inside(bench.tools, most_cells, context);
  }
};

bool same(const DomainMesh& a, const DomainMesh& b) {
  if (a.n_slots() != b.n_slots() || a.points() != b.points()) return false;
  for (CellIndex c = 0; c < a.n_slots(); ++c)
    if (a.is_live(c) != b.is_live(c) || (a.is_live(c) && a.vertices(c) != b.vertices(c))) return false;
  return true;
}

}  // namespace

TEST_CASE("A mesh taken apart by components and put together again is what it was", "[remesh]") {
  Bench bench(two_boxes(1));
  const double volume = bench.volume();
  const std::size_t n_cells = bench.mesh.n_cells(), n_vertices = bench.mesh.n_vertices(),
                    n_faces = n_constrained(bench.mesh);
  std::vector<MeshPart> parts = bench.mesh.take_apart();
  REQUIRE(parts.size() == 2);
  CHECK(bench.mesh.n_cells() == 0);
  for (const MeshPart& part : parts) {
    CHECK(part.mesh.validate() == "");
    CHECK(part.mesh.n_cells() < n_cells);
  }
  bench.mesh.put_together(std::move(parts));
  CHECK(bench.mesh.validate() == "");
  CHECK(bench.mesh.n_cells() == n_cells);
  CHECK(bench.mesh.n_vertices() == n_vertices);
  CHECK(n_constrained(bench.mesh) == n_faces);
  CHECK(bench.volume() == Approx(volume));
}

TEST_CASE("Components refined at once are one valid mesh, whatever the number of threads", "[remesh]") {
  ToRefine one, two;
  const double volume = one.bench.volume();
  const std::size_t n_points = one.refine(1);
  CHECK(n_points > 50);
  CHECK(n_points == one.bench.statistics.points_inside);
  CHECK(one.bench.mesh.validate() == "");
  CHECK(one.bench.volume() == Approx(volume));
  CHECK(two.refine(2) == n_points);
  CHECK(same(one.bench.mesh, two.bench.mesh));
}

TEST_CASE("Components together may not have more cells than are allowed", "[remesh]") {
  ToRefine all;
  all.refine(1);
  for (const unsigned threads : {1u, 2u})
    CHECK_THROWS_AS(ToRefine().refine(threads, all.bench.mesh.n_cells() - 1), Error);
}
