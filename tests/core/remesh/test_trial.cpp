// SPDX-License-Identifier: MIT
// Groups of operations that are undone: the mesh afterwards is the one before, to be seen from outside or by what comes
// next.
#include <catch2/catch.hpp>
#include <random>

#include "quality/measure/shape.hpp"
#include "refine_bench.hpp"
#include "remesh/operations/improve.hpp"
#include "remesh/rescue/bad_cells.hpp"
#include "remesh/rescue/rescue.hpp"
#include "remesh/rescue/trial.hpp"

using namespace geomesh;
using namespace geomesh::remesh;
using namespace refine_models;

namespace {

/// One operation of any kind at a place, both by chance. Returns its kind where something changed, else no_index.
Index operate(Bench& b, std::mt19937& random) {
  CellIndex c = random() % b.mesh.n_slots();
  while (!b.mesh.is_live(c)) c = (c + 1) % b.mesh.n_slots();
  const Tetrahedron t = b.mesh.vertices(c);
  const auto& e = edge_vertices[random() % 6];
  const VertexIndex u = t[e[0]], v = t[e[1]];
  const Vec3 centre = 0.25 * (b.mesh.point(t[0]) + b.mesh.point(t[1]) + b.mesh.point(t[2]) + b.mesh.point(t[3]));
  const Index kind = random() % 8;
  const auto done = [&] {
    switch (kind) {
      case 0:
        return split_edge(b.tools, c, u, v).has_value();
      case 1:
        return try_collapse(b.tools, u, v, CollapseRule::coarsen, 1e-3);
      case 2:
        return insert_inside(b.tools, centre, c, {LocalLength(1e-3), 1e-6}).has_value();
      case 3:
        return remove_edge(b.tools, c, u, v);
      case 4:
        return remove_face_above(b.tools, c, random() % 4, 0.1);
      case 5:
        return smooth_vertex(b.tools, u, {});
      case 6:
        return split_to_improve(b.tools, c, u, v);
      default:
        return insert_to_improve(b.tools, c);
    }
  };
  return done() ? kind : no_index;
}

void require_same(const DomainMesh& a, const DomainMesh& b) {
  REQUIRE(a.n_vertices() == b.n_vertices());
  REQUIRE(a.n_slots() == b.n_slots());
  REQUIRE(a.n_cells() == b.n_cells());
  REQUIRE(a.curve_edges() == b.curve_edges());
  std::size_t different = 0;
  for (VertexIndex v = 0; v < a.n_vertices(); ++v)
    different += !(a.point(v) == b.point(v) && a.kind(v) == b.kind(v) && a.support(v) == b.support(v) &&
                   a.incident_cell(v) == b.incident_cell(v) && a.changed_at(v) == b.changed_at(v));
  CHECK(different == 0);
  for (const auto& [u, v] : a.curve_edges()) different += a.curve_of(u, v) != b.curve_of(u, v);
  CHECK(different == 0);
  for (CellIndex c = 0; c < a.n_slots(); ++c) {
    different += a.is_live(c) != b.is_live(c);
    if (!a.is_live(c) || !b.is_live(c)) continue;
    different +=
        !(a.vertices(c) == b.vertices(c) && a.component(c) == b.component(c) && a.shape_of(c) == b.shape_of(c));
    for (unsigned i = 0; i < 4; ++i)
      different += !(a.tag(c, i) == b.tag(c, i) && a.cells().neighbor(c, i) == b.cells().neighbor(c, i));
  }
  CHECK(different == 0);
}

std::size_t n_below(const DomainMesh& mesh, double shape, double& least) {
  std::size_t n = 0;
  for (CellIndex c = 0; c < mesh.n_slots(); ++c)
    if (mesh.is_live(c)) n += mesh.shape_of(c) < shape, least = std::min(least, mesh.shape_of(c));
  return n;
}

}  // namespace

TEST_CASE("What is undone leaves the mesh as it was, and what follows is the same", "[trial]") {
  std::array<unsigned, 8> n_done{};
  for (const double tolerance : {0.0, 0.05})
    for (Model model : {box_with_well(4), ball_in_box(4), two_boxes(3)}) {
      disturb_inside(model, 7);
      Bench tried(model, tolerance), untouched(model, tolerance);
      std::mt19937 random(3), same(3);
      for (unsigned round = 0; round < 12; ++round) {
        std::size_t n_trials = 0;
        {
          const Trial trial(tried.tools);
          std::mt19937 other(100 + round);
          for (unsigned k = 0; k < 40; ++k) {
            const Index kind = operate(tried, other);
            if (kind != no_index) ++n_done[kind], ++n_trials;
          }
          REQUIRE(tried.mesh.validate() == "");
        }
        CHECK(n_trials > 0);
        require_same(tried.mesh, untouched.mesh);
        CHECK(tried.statistics.collapses == untouched.statistics.collapses);
        CHECK(tried.statistics.points_inside == untouched.statistics.points_inside);
        CHECK(tried.mesh.tick() == untouched.mesh.tick());
        // The order of free slots shows in what is made next.
        for (unsigned k = 0; k < 20; ++k) CHECK(operate(tried, random) == operate(untouched, same));
        require_same(tried.mesh, untouched.mesh);
        REQUIRE(tried.mesh.validate() == "");
      }
    }
  CAPTURE(n_done);
  CHECK(std::all_of(n_done.begin(), n_done.end(), [](unsigned n) { return n > 0; }));
}

TEST_CASE("What is kept stays", "[trial]") {
  Bench tried(box_with_well(4)), plain(box_with_well(4));
  std::mt19937 random(5), same(5);
  {
    Trial trial(tried.tools);
    for (unsigned k = 0; k < 60; ++k) operate(tried, random);
    trial.keep();
  }
  plain.tools.bad_cells_may_spread = true;
  for (unsigned k = 0; k < 60; ++k) operate(plain, same);
  require_same(tried.mesh, plain.mesh);
  CHECK(tried.statistics.collapses == plain.statistics.collapses);
  CHECK_FALSE(tried.tools.bad_cells_may_spread);
}

namespace {

std::vector<CellIndex> first_of(const DomainMesh&, std::span<const CellIndex> cells) {
  return {cells.begin(), cells.begin() + (cells.empty() ? 0 : 1)};
}
/// To them one is free, none is, or there are always several.
const FreeCellJudge one_is_free{{}, {}, first_of},
    none_is_free{{}, {}, [](const DomainMesh&, auto) { return std::vector<CellIndex>(); }},
    several_are_free{{}, {}, [](const DomainMesh&, std::span<const CellIndex> cells) {
                       return std::vector<CellIndex>(2 * cells.size(), cells.empty() ? no_cell : cells[0]);
                     }};

/// A search of its own about each cell.
template <std::size_t n_trials>
bool rescue_by_search(Toolbox& tools, CellIndex c, const RescueRule& rule) {
  RescueSearch search{Random(c), n_trials, n_trials, [] { return false; }, several_are_free};
  return rescue_cell_by_search(tools, c, rule, search);
}

bool rescue_by_openings(Toolbox& tools, CellIndex c, const RescueRule& rule) {
  VainTrials many{1'000'000};
  return rescue_cell_by_openings(tools, c, rule, many);
}

/// Rescues all bad cells of disturbed meshes, and holds each rescue to what it promises.
void judge_rescue(bool (*rescue)(Toolbox&, CellIndex, const RescueRule&), double bad_degrees, unsigned n_models) {
  std::size_t n_kept = 0, n_undone = 0;
  for (unsigned seed = 1; seed <= n_models; ++seed) {
    Model model = ball_in_box(4);
    disturb_inside(model, seed);
    Bench bench(std::move(model));
    const RescueRule rule{DihedralMeasure::of_angle(bad_degrees), 12, 30};
    for (CellIndex c = 0; c < bench.mesh.n_slots(); ++c) {
      if (!bench.mesh.is_live(c) || bench.mesh.shape_of(c) >= rule.bad_shape) continue;
      const DomainMesh copy = bench.mesh;
      double before = 1, after = 1;
      const std::size_t n_before = n_below(copy, rule.bad_shape, before);
      if (rescue(bench.tools, c, rule)) {
        ++n_kept;
        const std::size_t n_after = n_below(bench.mesh, rule.bad_shape, after);
        CHECK(after >= before);
        CHECK(n_after <= n_before);
      } else {
        ++n_undone;
        require_same(bench.mesh, copy);
      }
      REQUIRE(bench.mesh.validate() == "");
    }
  }
  CHECK(n_kept > 0);
  CHECK(n_undone > 0);
}

}  // namespace

TEST_CASE("A rescue that is kept leaves fewer bad cells, or as many and better ones; another leaves all as it was",
          "[trial]") {
  judge_rescue(rescue_cell, 20, 6);
}

TEST_CASE("So does one that opens by making the place worse", "[trial]") { judge_rescue(rescue_by_openings, 40, 1); }

TEST_CASE("So does a search", "[trial]") { judge_rescue(rescue_by_search<2>, 35, 1); }

TEST_CASE("A search makes no cell worse than the worst, and more bad ones only where they are forced", "[trial]") {
  for (const FreeCellJudge* judge : {&one_is_free, &none_is_free}) {
    std::size_t n_more = 0, n_mended = 0;
    Model model = ball_in_box(4);
    disturb_inside(model, 1);
    Bench bench(std::move(model));
    const RescueRule rule{DihedralMeasure::of_angle(50), 12, 30};
    for (CellIndex c = 0; c < bench.mesh.n_slots(); c += 4) {
      if (!bench.mesh.is_live(c) || bench.mesh.shape_of(c) >= rule.bad_shape) continue;
      const DomainMesh copy = bench.mesh;
      const Tetrahedron vertices = copy.vertices(c);
      double before = 1, after = 1;
      const std::size_t n_before = n_below(copy, rule.bad_shape, before);
      RescueSearch search{Random(c), 3, 3, [] { return false; }, *judge};
      const bool is_mended = rescue_cell_by_search(bench.tools, c, rule, search);
      const std::size_t n_after = n_below(bench.mesh, rule.bad_shape, after);
      CHECK(after >= before);
      CHECK(n_after <= n_before + (judge == &none_is_free));
      if (is_mended)
        CHECK_FALSE((bench.mesh.is_live(c) && bench.mesh.vertices(c) == vertices &&
                     bench.mesh.shape_of(c) == copy.shape_of(c)));
      n_more += n_after > n_before;
      n_mended += is_mended;
      REQUIRE(bench.mesh.validate() == "");
    }
    CAPTURE(judge == &none_is_free, n_more, n_mended);
    CHECK(n_mended > 0);
    if (judge == &none_is_free) CHECK(n_more > 0);
  }
}

TEST_CASE("Openings mend cells that are beyond a rescue without, a search cells that are beyond openings", "[trial]") {
  std::size_t n_by_openings = 0, n_by_search = 0;
  for (unsigned seed = 1; seed <= 4 && n_by_openings * n_by_search == 0; ++seed) {
    Model model = ball_in_box(4);
    disturb_inside(model, seed);
    Bench bench(std::move(model));
    const RescueRule rule{DihedralMeasure::of_angle(30), 12, 30};
    for (CellIndex c = 0; c < bench.mesh.n_slots(); ++c) {
      if (!bench.mesh.is_live(c) || bench.mesh.shape_of(c) >= rule.bad_shape || rescue_cell(bench.tools, c, rule))
        continue;
      if (rescue_by_openings(bench.tools, c, rule))
        ++n_by_openings;
      else
        n_by_search += rescue_by_search<20>(bench.tools, c, rule);
    }
  }
  CHECK(n_by_openings > 0);
  CHECK(n_by_search > 0);
}

TEST_CASE("Openings in vain are counted, those about a cell that is mended are not, and there are no more than allowed",
          "[trial]") {
  Model model = ball_in_box(4);
  disturb_inside(model, 1);
  Bench bench(std::move(model));
  const RescueRule rule{DihedralMeasure::of_angle(40), 12, 30};
  std::size_t n_mended = 0, n_in_vain = 0;
  for (CellIndex c = 0; c < bench.mesh.n_slots(); ++c) {
    if (!bench.mesh.is_live(c) || bench.mesh.shape_of(c) >= rule.bad_shape) continue;
    constexpr std::size_t many = 1'000'000;
    VainTrials none{0}, few{3}, vain{many};
    CHECK_FALSE(rescue_cell_by_openings(bench.tools, c, rule, none));
    if (rescue_cell_by_openings(bench.tools, c, rule, few)) {
      CHECK(few.left == 3);
      ++n_mended;
    } else {
      CHECK(few.left == 0);
      const bool is_mended = rescue_cell_by_openings(bench.tools, c, rule, vain);
      CHECK((vain.left == many) == is_mended);
      n_mended += is_mended;
      n_in_vain += !is_mended;
    }
  }
  CHECK(n_mended > 0);
  CHECK(n_in_vain > 0);
  constexpr std::size_t most = 20'000;
  CHECK(vain_trials(10, most).left == vain_trials(0, most).left);
  CHECK(vain_trials(100'000'000, most).left > vain_trials(10, most).left);
  CHECK(vain_trials(100'000'000, most).left == most);
}

TEST_CASE("A contraction that is mended takes a point away and leaves no cell worse than the worst, nor more bad ones",
          "[trial]") {
  Model model = ball_in_box(4);
  disturb_inside(model, 2);
  Bench bench(std::move(model));
  DomainMesh& mesh = bench.mesh;
  const RescueRule rule{DihedralMeasure::of_angle(30), 12, 30};
  std::size_t n_kept = 0, n_beyond_plain = 0, n_undone = 0;
  for (CellIndex c = 0; c < mesh.n_slots(); c += 3) {
    if (!mesh.is_live(c)) continue;
    const Tetrahedron t = mesh.vertices(c);
    const DomainMesh copy = mesh;
    double before = 1, after = 1;
    const std::size_t n_before = n_below(copy, rule.bad_shape, before);
    if (collapse_mending(bench.tools, t[0], t[1], rule)) {
      ++n_kept;
      CHECK(mesh.kind(t[0]) == VertexKind::dead);
      CHECK(n_below(mesh, rule.bad_shape, after) <= n_before);
      CHECK(after >= before);
      mesh = copy;
      n_beyond_plain += !try_collapse(bench.tools, t[0], t[1], CollapseRule::thin_out, rule.bad_shape);
      mesh = copy;
    } else {
      ++n_undone;
      require_same(mesh, copy);
    }
    REQUIRE(mesh.validate() == "");
  }
  CHECK(n_kept > 0);
  CHECK(n_beyond_plain > 0);
  CHECK(n_undone > 0);
}

TEST_CASE("A search tries no more often than it may, and not at all when time is over", "[trial]") {
  Model model = ball_in_box(4);
  disturb_inside(model, 1);
  Bench bench(std::move(model));
  const RescueRule rule{DihedralMeasure::of_angle(60), 12,
                        30};  // nothing is that good, so all is in vain or little is gained
  RescueSearch search{Random(1), 3, 4, [] { return false; }, several_are_free};
  CellIndex c = 0;
  while (!bench.mesh.is_live(c)) ++c;
  const bool first = rescue_cell_by_search(bench.tools, c, rule, search);
  CHECK(search.trials_left >= 1);
  if (!first) CHECK(search.trials_left == 1);
  RescueSearch late{Random(1), 3, 4, [] { return true; }, several_are_free};
  CHECK_FALSE(rescue_cell_by_search(bench.tools, c, rule, late));
  CHECK(late.trials_left == 4);
}

TEST_CASE("Openings open cells however flat, and not only those about them", "[trial]") {
  Bench bench(box_with_ridge(1e-4));
  CellIndex flat = 0;
  while (!bench.mesh.is_live(flat) || bench.mesh.shape_of(flat) > 1e-3) ++flat;
  const BadCell seed = bad_cell(bench.mesh, flat);
  Random choose(1);
  std::size_t n = 0;
  for (unsigned k = 0; k < 200; ++k) {
    const Trial trial(bench.tools);
    n += open_about_cell(bench.tools, flat, choose) && !is_left(bench.mesh, seed);
  }
  CHECK(n > 35);
}

TEST_CASE("Openings keep the mesh valid and its domain, and are the same from the same seed", "[trial]") {
  Bench bench(box_with_well(4)), same(box_with_well(4));
  const double before = bench.volume();
  Random choose(7), again(7);
  std::size_t n = 0;
  for (CellIndex c = 0; c < 400; ++c) {
    if (!bench.mesh.is_live(c)) continue;
    const bool is_open = open_about_cell(bench.tools, c, choose);
    REQUIRE(open_about_cell(same.tools, c, again) == is_open);
    REQUIRE(bench.mesh.validate() == "");
    n += is_open;
  }
  CHECK(n > 50);
  CHECK(bench.volume() == Approx(before));
  CHECK(bench.statistics.collapses > 0);
  CHECK(bench.statistics.points_inside > 0);
  CHECK(bench.statistics.points_on_surfaces > 0);
  CHECK(bench.statistics.edge_removals > 0);
  CHECK(bench.statistics.face_removals > 0);
  require_same(bench.mesh, same.mesh);
}
