// SPDX-License-Identifier: MIT
// Blocks that are worked on side by side: whose cells are whose, what is refused, and that threads change nothing.
#include <catch2/catch.hpp>

#include "refine_bench.hpp"
#include "remesh/passes/block_pass.hpp"
#include "remesh/passes/improve_passes.hpp"
#include "remesh/passes/passes.hpp"

using namespace refine_models;

namespace {

constexpr MeshBlocks::Rules small_blocks{
    .vertices_a_block = 30, .least_inside = 0, .least_on_surfaces = 0, .is_checked = true};

RunContext on_threads(unsigned n) {
  RunContext context;
  context.threads = n;
  return context;
}

Model disturbed_boxes() {
  Model model = two_boxes(9);
  disturb_inside(model, 11);
  return model;
}

/// All that a run may leave behind: places, cells in their slots with links and shapes, times.
struct State {
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 8>> cells;
  std::vector<double> shapes;
  std::vector<std::uint64_t> times;
  std::size_t edge_removals, face_removals, moves;
  bool operator==(const State&) const = default;
};

State state_of(Bench& bench) {
  State s{bench.mesh.points(),
          {},
          {},
          {},
          bench.statistics.edge_removals,
          bench.statistics.face_removals,
          bench.statistics.smoothing_moves};
  for (const CellIndex c : bench.mesh.live_cells()) {
    std::array<std::uint32_t, 8> cell{c};
    for (unsigned i = 0; i < 4; ++i)
      cell.at(i) = bench.mesh.vertices(c)[i], cell.at(4 + i) = bench.mesh.cells().neighbor(c, i).code;
    s.cells.push_back(cell);
    s.shapes.push_back(bench.mesh.shape_of(c));
  }
  for (VertexIndex v = 0; v < bench.mesh.n_vertices(); ++v) s.times.push_back(bench.mesh.changed_at(v));
  s.times.push_back(bench.mesh.tick());
  return s;
}

/// What `work` leaves behind of a model on so many threads, in small blocks.
template <class Work>
State state_after(unsigned threads, double tolerance, Model model, const Work& work) {
  Bench bench(std::move(model), tolerance);
  bench.tools.block_rules = small_blocks;
  bench.tools.bad_cells_may_spread = true;
  const RunContext context = on_threads(threads);
  work(bench, context);
  CHECK(bench.mesh.validate() == "");
  return state_of(bench);
}

}  // namespace

TEST_CASE("A vertex is inside of its block where all cells about it are", "[improve]") {
  Bench bench(disturbed_boxes());
  const DomainMesh& mesh = bench.mesh;
  std::vector<std::size_t> n_inner;
  std::vector<std::uint8_t> inner_of_any(mesh.n_vertices(), 0);
  for (unsigned division = 0; division < 2; ++division) {
    const MeshBlocks blocks(mesh, division, small_blocks, 2);
    REQUIRE(blocks.size() >= 8);
    const std::vector<std::uint8_t> inner = blocks.find_inner(mesh, 2);
    std::vector<std::uint8_t> expected(mesh.n_vertices(), 1);
    for (const CellIndex c : mesh.live_cells())
      for (const VertexIndex v : mesh.vertices(c))
        for (const VertexIndex w : mesh.vertices(c))
          if (blocks.block_of(v) != blocks.block_of(w)) expected[v] = 0;
    CHECK(inner == expected);
    n_inner.push_back(static_cast<std::size_t>(std::ranges::count(inner, 1)));
    for (VertexIndex v = 0; v < mesh.n_vertices(); ++v) inner_of_any[v] |= inner[v];
  }
  CHECK(n_inner[0] > 0);
  CHECK(std::ranges::count(inner_of_any, 1) > static_cast<std::ptrdiff_t>(n_inner[0]));  // borders are elsewhere
}

TEST_CASE("An operation that reaches cells of another block is refused, and noted", "[improve]") {
  Bench bench(disturbed_boxes());
  DomainMesh& mesh = bench.mesh;
  bench.tools.bad_cells_may_spread = true;
  const MeshBlocks blocks(mesh, 0, small_blocks, 1);
  BlockEdit edit;
  edit.blocks = &blocks;
  mesh.open_block(edit, 64);
  bench.tools.block = &edit;
  std::size_t n_done = 0, n_refused = 0;
  for (CellIndex c = 0; c < mesh.n_slots(); ++c)
    for (unsigned i = 0; i < 4 && mesh.is_live(c); ++i) {
      if (mesh.tag(c, i).constrained()) continue;
      const bool is_own =
          blocks.has(0, mesh.vertices(c)) && blocks.has(0, mesh.vertices(mesh.cells().neighbor_cell(c, i)));
      edit.was_stopped = false;
      const bool done = remove_face_above(bench.tools, c, i, 1e-3);
      CHECK((!done || is_own));
      CHECK((!edit.was_stopped || !is_own));
      n_done += done, n_refused += edit.was_stopped;
      if (done) break;
    }
  CHECK(n_done > 0);
  CHECK(n_refused > 0);
  mesh.close_block(edit);
  CHECK(mesh.validate() == "");
}

TEST_CASE("An operation that finds no slot is put off", "[improve]") {
  Bench bench(disturbed_boxes());
  const MeshBlocks blocks(bench.mesh, 0, {.vertices_a_block = 1'000'000}, 1);
  REQUIRE(blocks.size() == 1);
  BlockEdit edit;
  edit.blocks = &blocks;
  bench.mesh.open_block(edit, 0);
  CHECK(edit.may_exchange(bench.mesh, std::array{CellIndex{0}, CellIndex{1}}, 2));
  CHECK_FALSE(edit.was_stopped);
  CHECK_FALSE(edit.may_exchange(bench.mesh, std::array{CellIndex{0}, CellIndex{1}}, 3));
  CHECK(edit.was_stopped);
}

TEST_CASE("Two blocks that write one face of a cell are told", "[improve]") {
  FaceClaims claims(2);
  claims.claim(FaceRef(1, 2), 4);
  claims.claim(FaceRef(1, 2), 4);
  claims.claim(FaceRef(1, 3), 5);
  CHECK_THROWS_AS(claims.claim(FaceRef(1, 2), 5), InternalError);
}

TEST_CASE("What blocks do depends on no number of threads, and no two of them touch one cell", "[improve]") {
  const auto raise = [](Bench& bench, const RunContext& context) {
    for (unsigned round = 0; round < 2; ++round) raise_mean(bench.tools, 0.2, 6, context);
  };
  const auto make_regular = [](Bench& bench, const RunContext& context) {
    split_long_edges(bench.tools, LongEdges::of_surfaces, 1'000'000, context);
    InVainOnSurfaces in_vain;
    make_surfaces_regular(bench.tools, in_vain, context);
  };
  Model ball = ball_in_box(8);
  disturb_inside(ball, 11);
  for (const double tolerance : {0.0, 0.02}) {
    const State raised = state_after(1, tolerance, disturbed_boxes(), raise);
    CHECK(raised.edge_removals + raised.face_removals > 100);
    CHECK(raised.moves > 100);
    for (const unsigned threads : {2, 4, 8}) CHECK(state_after(threads, tolerance, disturbed_boxes(), raise) == raised);
  }
  const State regular = state_after(1, 0.05, ball, make_regular);
  CHECK(regular.edge_removals > 0);
  CHECK(regular.moves > 0);
  for (const unsigned threads : {2, 4, 8}) CHECK(state_after(threads, 0.05, ball, make_regular) == regular);
}

TEST_CASE("Each vertex is visited, again where it met a border", "[improve]") {
  Bench bench(disturbed_boxes());
  bench.tools.block_rules = small_blocks;
  bench.tools.bad_cells_may_spread = true;
  const RunContext context = on_threads(2);
  BlockPass blocks(bench.tools, context);
  std::vector<std::uint8_t> visits(bench.mesh.n_vertices(), 0), done(bench.mesh.n_vertices(), 0);
  const std::vector<VertexIndex> vertices = bench.mesh.vertices_by_cells();
  blocks.run(vertices, 0, [&](VertexIndex v, Toolbox& tools) {
    ++visits[v];
    if (tools.block && visits[v] == 1 && v % 5 == 0)
      tools.block->was_stopped = true;  // as an operation would
    else
      done[v] = 1;
  });
  const BlockPass::Counts& counts = blocks.counts();
  CHECK(counts.put_off > 0);
  CHECK(counts.in_blocks - counts.put_off + counts.by_one_thread == vertices.size());
  for (const VertexIndex v : vertices) CHECK(done[v] == 1);
}
