// SPDX-License-Identifier: GPL-3.0-or-later
// Fault blocks: which there are, which block holds a place, and what becomes of faults that end on others.
#include <catch2/catch.hpp>
#include <map>
#include <random>
#include <set>

#include "geomesh/geomodel/model_rules.hpp"
#include "naming/sums.hpp"
#include "rules/framework/block_framework.hpp"
#include "rules/framework/end_on_faults.hpp"

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
