// SPDX-License-Identifier: GPL-3.0-or-later
// Units by the horizons as they were laid down, where they leave one or several.
#include <catch2/catch.hpp>

#include "naming/units_by_heights.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

/// One component of tetrahedra of equal volume, from x = 0 on, one for each range.
UnitVerdict found(const UnitVerdict& verdict, const std::vector<UnitRange>& left) {
  ConstrainedTetrahedralization mesh;
  mesh.n_components = 1;
  for (std::size_t k = 0; k < left.size(); ++k) {
    const auto x = static_cast<double>(k);
    const auto first = static_cast<VertexIndex>(mesh.points.size());
    for (const Vec3& p : {Vec3{x, 0, 0}, Vec3{x + 0.9, 0, 0}, Vec3{x, 1, 0}, Vec3{x, 0, 1}}) mesh.points.push_back(p);
    mesh.tetrahedra.push_back({first, first + 1, first + 2, first + 3});
    mesh.component.push_back(0);
  }
  Column column;
  column.units = {"u1", "u2", "u3", "u4"};
  column.horizons = {0, 1, 2};
  NamingRules rules;
  rules.units_at = [&](const Vec3& p) { return left[static_cast<std::size_t>(p.x)]; };
  std::vector<UnitVerdict> verdicts{verdict};
  find_units_by_heights(mesh, rules, column, verdicts);
  return verdicts[0];
}

/// The faces leave these units, of which the last one is next to a horizon.
UnitVerdict incomplete(Index first, Index last) {
  return {UnitVerdict::Kind::incomplete, last, last, first, last, false};
}

}  // namespace

TEST_CASE("heights: the unit that most places leave is the component's", "[sets]") {
  const UnitVerdict verdict = found(incomplete(0, 2), {{1, 1}, {1, 1}, {1, 1}, {0, 0}});
  CHECK(verdict.first == 1);
  CHECK(verdict.last == 1);
  CHECK(verdict.by_heights);
}

TEST_CASE("heights: units that a missing horizon leaves bound the component's", "[sets]") {
  // Found by seed 1495739 of the random models (--light): a block was named u3 where a horizon that had been cut away
  // left u1 and u2.
  const UnitVerdict verdict = found(incomplete(0, 2), {{0, 1}, {0, 1}, {0, 1}, {0, 3}});
  CHECK(verdict.first == 1);
  CHECK(verdict.last == 1);
  CHECK(verdict.first_possible == 0);
  CHECK(verdict.last_possible == 1);
  CHECK_FALSE(verdict.by_heights);
}

TEST_CASE("heights: places that leave different units bound the component's by both", "[sets]") {
  const UnitVerdict verdict = found(incomplete(0, 3), {{1, 1}, {1, 1}, {2, 2}, {2, 2}});
  CHECK(verdict.first == 2);
  CHECK(verdict.first_possible == 1);
  CHECK(verdict.last_possible == 2);
}

TEST_CASE("heights: what the faces rule out, and what few places tell, changes nothing", "[sets]") {
  const std::vector<UnitRange> left =
      GENERATE(std::vector<UnitRange>{{3, 3}, {3, 3}, {3, 3}, {3, 3}},           // not possible
               std::vector<UnitRange>{{2, 1}, {2, 1}, {0, 1}, {0, 3}},           // most contradict themselves
               std::vector<UnitRange>{{0, 3}, {0, 3}, {0, 3}, {0, 3}},           // nothing is told
               std::vector<UnitRange>{{0, 3}, {0, 3}, {0, 3}, {0, 3}, {1, 1}});  // a fifth of the volume tells
  const UnitVerdict verdict = found(incomplete(0, 2), left);
  CHECK(verdict.first == 2);
  CHECK(verdict.first_possible == 0);
  CHECK(verdict.last_possible == 2);
  CHECK_FALSE(verdict.by_heights);
}

TEST_CASE("heights: a component that touches no horizon takes the nearest of the units that are left", "[sets]") {
  UnitVerdict touches_none;
  touches_none.kind = UnitVerdict::Kind::vertical;
  touches_none.first = touches_none.last = 3;
  const UnitVerdict other = found(touches_none, {{1, 2}, {1, 2}});
  CHECK(other.first == 2);
  CHECK(other.by_heights);
  touches_none.first = touches_none.last = 1;
  const UnitVerdict same = found(touches_none, {{1, 2}, {1, 2}});
  CHECK(same.first == 1);
  CHECK_FALSE(same.by_heights);
}

TEST_CASE("heights: a verdict of one unit is not asked about", "[sets]") {
  UnitVerdict told;
  told.kind = UnitVerdict::Kind::unit;
  told.first = told.last = told.first_possible = told.last_possible = 3;
  CHECK(found(told, {{1, 1}, {1, 1}}).first == 3);
}
