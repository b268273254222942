// SPDX-License-Identifier: GPL-3.0-or-later
// What rules may have taken of a surface, at their limits: on the limit and within the room beyond it, not farther.
#include <catch2/catch.hpp>

#include "check/claim/taken_by_rules.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::checking;

namespace {

/// A level square of half a width of 5 at the height, seen from above.
TriangulatedSurface level(double height) {
  TriangulatedSurface s;
  s.points = {{-5, -5, height}, {5, -5, height}, {5, 5, height}, {-5, 5, height}};
  s.triangles = {{0, 1, 2}, {2, 3, 0}};
  return s;
}

}  // namespace

TEST_CASE("Above and below another surface are told on the vertical, and beside it at the nearest point", "[check]") {
  constexpr double room = 0.125, half = room / 2;
  for (const bool above : {true, false}) {
    Claim claim;
    claim.surfaces = {level(0), level(3)};
    claim.trims.resize(2);
    (above ? claim.trims[0].above : claim.trims[0].below) = {1};
    const TakenByRules taken(claim, room);
    const double beyond = above ? 1 : -1;
    for (const double x : {0.0, 20.0}) {  // over the other surface, and beside it
      CHECK(taken.may_be_away(0, 0, {x, 0.5, 3 + beyond}));
      CHECK(taken.may_be_away(0, 0, {x, 0.5, 3}));
      CHECK(taken.may_be_away(0, 0, {x, 0.5, 3 - half * beyond}));
      CHECK_FALSE(taken.may_be_away(0, 0, {x, 0.5, 3 - 2 * room * beyond}));
      CHECK_FALSE(taken.may_be_away(1, 0, {x, 0.5, 3 + beyond}));  // of which no rule takes anything
    }
  }
}
