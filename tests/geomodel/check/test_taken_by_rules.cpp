// SPDX-License-Identifier: GPL-3.0-or-later
// What rules may have taken of a surface, at their limits: on the limit and within the room beyond it, not farther.
#include <catch2/catch.hpp>

#include "check/pieces/taken_pieces.hpp"
#include "check/specification/taken_by_rules.hpp"

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
    Specification specification;
    specification.surfaces = {level(0), level(3)};
    specification.trims.resize(2);
    (above ? specification.trims[0].above : specification.trims[0].below) = {1};
    const TakenByRules taken(specification, room);
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

TEST_CASE("A piece is away as a whole where most of it is beyond what cuts it and it ends there", "[check]") {
  TriangulatedSurface strip;  // of four triangles in a row
  strip.points = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}, {2, 1, 0}};
  strip.triangles = {{0, 2, 1}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}};
  const std::array<bool, 3> on{true, true, true};
  const auto left = [&](double beyond, bool ends, bool joined) {
    std::vector<UncoveredTriangle> uncovered{{0, beyond, 0, on, ends, {}}, {1, 0, 0.5, on, true, {}}};
    if (!joined) uncovered[1].goes_on = {false, false, false};
    return not_taken_as_pieces(strip, uncovered);
  };
  CHECK(left(0.6, true, true).empty());
  CHECK(left(0.4, true, true) == std::vector<Index>{1});                    // most of it is not beyond
  CHECK(left(0.6, false, true) == std::vector<Index>{1});                   // it ends elsewhere, too
  CHECK(left(0.6, true, false) == std::vector<Index>{1});                   // another piece
  CHECK(not_taken_as_pieces(strip, {{0, 0.5, 0, on, false, {}}}).empty());  // place by place, none is missing
}

TEST_CASE("Pieces go on across points that a surface has twice", "[check]") {
  TriangulatedSurface parts;
  parts.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  parts.triangles = {{0, 1, 2}, {3, 4, 5}};
  const std::array<bool, 3> on{true, true, true};
  CHECK(not_taken_as_pieces(parts, {{0, 0.6, 0, on, true, {}}, {1, 0, 0.5, on, true, {}}}).empty());
}
