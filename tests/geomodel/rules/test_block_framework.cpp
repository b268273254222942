// SPDX-License-Identifier: GPL-3.0-or-later
// Fault blocks: which there are, which block holds a place, and what becomes of faults that end on others.
#include <catch2/catch.hpp>
#include <map>
#include <random>
#include <set>
#include <tuple>

#include "geomesh/geomodel/model_rules.hpp"
#include "naming/sums.hpp"
#include "rules/framework/block_framework.hpp"
#include "rules/framework/end_on_faults.hpp"
#include "rules/framework/fault_truncations.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

constexpr double side = 10;
constexpr double within = 0.5;

/// A rectangle of four corners in order.
TriangulatedSurface rectangle(const std::string& name, const std::array<Vec3, 4>& corners) {
  TriangulatedSurface s;
  s.name = name;
  s.kind = SurfaceKind::fault;
  s.points.assign(corners.begin(), corners.end());
  s.triangles = {{0, 1, 2}, {0, 2, 3}};
  return s;
}

/// The plane x = 5 + z / 10 through the model.
TriangulatedSurface leaning_fault() {
  return rectangle("f", {Vec3{4.9, -1, -1}, {4.9, side + 1, -1}, {6.1, side + 1, side + 1}, {6.1, -1, side + 1}});
}
/// The plane y = 5 to beyond the model, from a distance beyond that fault on.
TriangulatedSurface branch(double beyond) {
  return rectangle(
      "g", {Vec3{4.9 - beyond, 5, -1}, {side + 1, 5, -1}, {side + 1, 5, side + 1}, {6.1 - beyond, 5, side + 1}});
}

BuiltSurfaces built_of(const std::vector<TriangulatedSurface>& surfaces) {
  BuiltSurfaces built;
  built.surfaces = surfaces;
  built.rows.first_only_parting.assign(surfaces.size(), no_index);
  return built;
}

ModelRules rules_of_box() {
  ModelRules rules;
  ContinuationRules& how = rules.continuation;
  how.within_of_faults = how.within_of_horizons = within;
  how.bounds.add(Vec3{0, 0, 0});
  how.bounds.add(Vec3{side, side, side});
  rules.box = how.bounds;
  how.sides = {TriangulatedSurface{}};  // a box: its bounds tell all
  return rules;
}

/// Places on both sides of a wall are never of one block, and places of one kind always are.
template <class F>
void require_blocks(const BlockFramework& framework, F&& kind_at) {
  std::mt19937 chance(7);
  std::uniform_real_distribution<double> along(0, side);
  std::map<int, std::set<Index>> blocks_of_kind;
  for (int k = 0; k < 2000; ++k) {
    const Vec3 p{along(chance), along(chance), along(chance)};
    const Index block = framework.block_at(p);
    REQUIRE(block < framework.n_blocks());
    blocks_of_kind[kind_at(p)].insert(block);
  }
  std::set<Index> all;
  for (const auto& [kind, blocks] : blocks_of_kind) {
    CHECK(blocks.size() == 1);
    all.insert(blocks.begin(), blocks.end());
  }
  CHECK(all.size() == blocks_of_kind.size());
  CHECK(framework.n_blocks() == all.size());
}

}  // namespace

TEST_CASE("Faults divide the model into blocks, and each place lies in the block that the planes tell") {
  BuiltSurfaces built = built_of({leaning_fault(), branch(3)});
  const ModelRules rules = rules_of_box();
  const BlockFramework framework(built, rules);  // g goes on for 3 m beyond f, and ends there
  CHECK(framework.n_blocks() == 3);
  Index n_with_tip = 0;
  for (Index b = 0; b < framework.n_blocks(); ++b) n_with_tip += framework.has_tip(b);
  CHECK(n_with_tip == 1);
  require_blocks(framework, [](const Vec3& p) { return p.x < 5 + p.z / 10 ? 0 : p.y < 5 ? 1 : 2; });
  CHECK(framework.block_at({side + 1, 5, 5}) == no_index);
}

TEST_CASE("A fault that runs a little beyond another one ends there, and leaves no tip in the block beyond") {
  BuiltSurfaces built = built_of({leaning_fault(), branch(0.3)});
  const ModelRules rules = rules_of_box();
  const EndedFaults ended = ended_faults(built, rules);
  CHECK(built.rows.overshooting == std::vector<Index>{1});
  double least = side;
  for (const Triangle& t : ended.surfaces[1].triangles)
    for (const VertexIndex v : t) {
      const Vec3& p = ended.surfaces[1].points[v];
      least = std::min(least, p.x - 5 - p.z / 10);
    }
  CHECK(std::abs(least) < 1e-12);
  const BlockFramework framework(built, rules);
  require_blocks(framework, [](const Vec3& p) { return p.x < 5 + p.z / 10 ? 0 : p.y < 5 ? 1 : 2; });
  for (Index b = 0; b < framework.n_blocks(); ++b) CHECK_FALSE(framework.has_tip(b));
}

TEST_CASE("A fault keeps its end where a rule tells its extent, and where it goes on for longer than the distance") {
  BuiltSurfaces built = built_of({leaning_fault(), branch(0.3)});
  ModelRules rules = rules_of_box();
  rules.surfaces.resize(2);
  rules.surfaces[1].continues = false;
  CHECK(ended_faults(built, rules).surfaces[1].triangles == built.surfaces[1].triangles);
  CHECK(built.rows.overshooting.empty());
  built = built_of({leaning_fault(), branch(2)});
  CHECK(ended_faults(built, rules_of_box()).surfaces[1].triangles == built.surfaces[1].triangles);
}

TEST_CASE("The line on which a fault ends on another one is no tip") {
  BuiltSurfaces built = built_of({leaning_fault(), branch(0.3)});
  for (const FaultTip& tip : ended_faults(built, rules_of_box()).tips)
    for (const Vec3& p : tip.ends)
      CHECK((p.x < 0 || p.x > side || p.y < 0 || p.y > side || p.z < 0 || p.z > side || p.x > 5 + p.z / 10 + 0.1));
}

namespace {

/// A horizon at one height beyond all sides of the model.
TriangulatedSurface flat_horizon(const std::string& name, double z) {
  TriangulatedSurface s =
      rectangle(name, {Vec3{-1, -1, z}, {side + 1, -1, z}, {side + 1, side + 1, z}, {-1, side + 1, z}});
  s.kind = SurfaceKind::horizon;
  return s;
}

/// The plane x = 5 to beyond the model, but for its upper border, which runs from one height to another in the model.
TriangulatedSurface fault_up_to(double z_at_south, double z_at_north) {
  TriangulatedSurface fault =
      rectangle("f", {Vec3{5, -1, -1}, {5, side + 1, -1}, {5, side + 1, z_at_north}, {5, -1, z_at_south}});
  // Its upper border has edges with their middles in the model, where it is looked at.
  fault.points.push_back(0.5 * (fault.points[2] + fault.points[3]));
  fault.triangles = {{0, 1, 4}, {1, 2, 4}, {0, 4, 3}};
  return fault;
}

/// The same with a row of triangles at the upper border, from z = 7.1 on.
TriangulatedSurface fault_with_upper_row() {
  TriangulatedSurface fault = fault_up_to(7.1, 7.1);
  const auto n = static_cast<VertexIndex>(fault.points.size());
  for (const double y : {-1.0, side / 2, side + 1.0}) fault.points.push_back({5, y, 7.4});
  for (const Triangle& t : {Triangle{3, 4, n}, Triangle{4, n + 1, n}, Triangle{4, 2, n + 1}, Triangle{2, n + 2, n + 1}})
    fault.triangles.push_back(t);
  return fault;
}

/// The horizons that truncate a fault with the rules given; `young` at z = 7 lies over `old` at z = 3.
std::vector<std::string> truncating(TriangulatedSurface fault, BaseRule of_young) {
  const std::vector<TriangulatedSurface> surfaces{flat_horizon("young", 7), flat_horizon("old", 3), std::move(fault)};
  ModelRules rules = rules_of_box();
  rules.column = {"a", "young", "b", "old", "c"};
  rules.surfaces.resize(3);
  rules.surfaces[0].base = of_young;
  std::vector<std::string> names;
  for (const auto& [row, horizon] : fault_truncations(surfaces, rules)) {
    CHECK(row == 2);
    names.push_back(surfaces[horizon].name);
  }
  return names;
}

}  // namespace

TEST_CASE("A triangle overlaps the blocks in which its places lie, and no others") {
  BuiltSurfaces built = built_of({leaning_fault(), branch(0.3)});
  const ModelRules rules = rules_of_box();
  ended_faults(built, rules);
  const BlockFramework framework(built, rules);
  std::mt19937 chance(11);
  std::uniform_real_distribution<double> along(-2, side + 2), share(0, 1);
  for (int k = 0; k < 300; ++k) {
    const auto place = [&] { return Vec3{along(chance), along(chance), along(chance)}; };
    const Vec3 a = place(), b = a + 0.3 * (place() - a), c = a + 0.3 * (place() - a);
    std::set<Index> seen;
    for (int i = 0; i < 2000; ++i) {
      double u = share(chance), v = share(chance);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      if (const Index block = framework.block_at(a + u * (b - a) + v * (c - a)); block != no_index) seen.insert(block);
    }
    for (const Index block : seen) CHECK(framework.overlaps(block, {a, b, c}));
    // What is told and was not seen reaches in by little: the blocks that are told are those about the triangle.
    if (seen.empty()) continue;
    Index n_told = 0;
    for (Index block = 0; block < framework.n_blocks(); ++block) n_told += framework.overlaps(block, {a, b, c});
    CHECK(n_told <= seen.size() + 1);
  }
}

TEST_CASE("A horizon truncates faults that end along it, and one that erodes those that come near to it") {
  using Names = std::vector<std::string>;
  CHECK(truncating(fault_up_to(6.7, 7.2), BaseRule::conformable) == Names{"young"});
  CHECK(truncating(fault_up_to(6.7, 6.8), BaseRule::conformable) == Names{"young"});
  CHECK(truncating(fault_up_to(7.2, 7.4), BaseRule::conformable) == Names{"young"});  // by less than its triangles
  CHECK(truncating(fault_with_upper_row(), BaseRule::conformable) == Names{});        // all above: it goes through
  CHECK(truncating(fault_up_to(5, 5), BaseRule::conformable) == Names{});             // it dies out between them
  CHECK(truncating(fault_up_to(5, 5), BaseRule::erode) == Names{});
  CHECK(truncating(fault_up_to(side + 1, side + 1), BaseRule::erode) == Names{});  // its border is outside
}

TEST_CASE("A horizon that truncates faults divides blocks, which know on which side of it they lie") {
  BuiltSurfaces built = built_of({flat_horizon("u", 7), fault_up_to(7.3, 7.3)});
  built.rows.truncations = {{1, 0}};
  const BlockFramework framework(built, rules_of_box());
  require_blocks(framework, [](const Vec3& p) { return p.z > 7 ? 0 : p.x < 5 ? 1 : 2; });
  CHECK(framework.side_of(framework.block_at({2, 5, 9}), 0) == 1);
  CHECK(framework.side_of(framework.block_at({2, 5, 3}), 0) == -1);
  CHECK(framework.side_of(framework.block_at({8, 5, 3}), 0) == -1);
  CHECK(framework.side_of(framework.block_at({8, 5, 3}), 1) == 0);
}

TEST_CASE("Blocks beyond another fault lie on the side of those that they hang together with") {
  const TriangulatedSurface second =
      rectangle("g", {Vec3{7.9, -1, -1}, {7.9, side + 1, -1}, {9.1, side + 1, side + 1}, {9.1, -1, side + 1}});
  const BlockFramework framework(built_of({leaning_fault(), second}), rules_of_box());
  const auto side_at = [&](const Vec3& p, Index fault) { return framework.sides_of(fault)[framework.block_at(p)]; };
  CHECK(framework.side_of(framework.block_at({9.5, 5, 1}), 0) == 0);
  for (const auto& [x, of_first, of_second] : {std::tuple{1.0, 1, 1}, {7.0, -1, 1}, {9.5, -1, -1}}) {
    CHECK(side_at({x, 5, 1}, 0) == of_first);
    CHECK(side_at({x, 5, 1}, 1) == of_second);
  }
}

TEST_CASE("A fault that ends inside the model has no sides") {
  const TriangulatedSurface short_fault =
      rectangle("f", {Vec3{4.9, -1, -1}, {4.9, 5, -1}, {6.1, 5, side + 1}, {6.1, -1, side + 1}});
  const BlockFramework framework(built_of({short_fault}), rules_of_box());
  CHECK(framework.sides_of(0) == std::vector<int>{0});
}
