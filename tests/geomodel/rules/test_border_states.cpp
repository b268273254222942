// SPDX-License-Identifier: GPL-3.0-or-later
// Which edges of a horizon's border stop short of a wall.
#include <catch2/catch.hpp>

#include "arrangement/model/ingest.hpp"
#include "rules/continuation/border_chains.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

/// An upright wall through the places of a line in the map.
TriangulatedSurface upright(const std::vector<Vec2>& line) {
  TriangulatedSurface wall;
  wall.kind = SurfaceKind::body;
  for (const Vec2& p : line)
    for (const double z : {-50.0, 50.0}) wall.points.push_back({p.x, p.y, z});
  for (VertexIndex k = 0; k + 2 < 2 * line.size(); k += 2) {
    wall.triangles.push_back({k, k + 2, k + 3});
    wall.triangles.push_back({k, k + 3, k + 1});
  }
  return wall;
}

/// A horizon on the left of its border from (0, -4) to (0, `end`), with one vertex inside.
TriangulatedSurface horizon_left_of(double end) {
  TriangulatedSurface h;
  h.kind = SurfaceKind::horizon;
  h.points = {{0, -4, 0}, {0, end, 0}, {-20, 2, 0}, {-8, 2, 0}};
  h.triangles = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return h;
}

BorderState state_of_side(const TriangulatedSurface& horizon, const TriangulatedSurface& wall, double within) {
  const std::vector<TriangulatedSurface> surfaces{horizon, wall};
  const Walls walls(surfaces, {1}, {});
  return border_states(horizon, 0, walls, {{-100, -100, -100}, {300, 100, 100}}, within).at({0, 1});
}

}  // namespace

TEST_CASE("A border edge stops short of a wall if a part of it does, wherever its middle lies", "[continuation]") {
  // The wall bulges to the left, over the border from y = 1.25 to y = 8.75; its body is on the right.
  const TriangulatedSurface wall = upright({{200, -10}, {3, -10}, {-1, 5}, {3, 20}, {200, 20}});
  CHECK(state_of_side(horizon_left_of(0), wall, 15) == BorderState::before_wall);    // wholly before it
  CHECK(state_of_side(horizon_left_of(8.5), wall, 15) == BorderState::before_wall);  // the middle lies in the body
  CHECK(state_of_side(horizon_left_of(8.5), wall, 0.1) == BorderState::open);        // too far from it
  CHECK(state_of_side(horizon_left_of(11), wall, 15) == BorderState::before_wall);   // both ends lie before it
}

TEST_CASE("An edge on a side of the box is continued into the box if its triangle lies outside", "[continuation]") {
  TriangulatedSurface h;
  h.kind = SurfaceKind::horizon;
  h.points = {{-10, -10, 0}, {-10, 10, 0}, {0, 10, 0}, {0, -10, 0}};
  h.triangles = {{0, 2, 1}, {0, 3, 2}};
  const TriangulatedSurface fault = upright({{8, -50}, {8, 50}});
  const std::vector<TriangulatedSurface> surfaces{h, fault};
  const Box3 right{{0, -100, -100}, {100, 100, 100}}, left{{-100, -100, -100}, {0, 100, 100}};
  const auto state = [&](const Box3& box, double within) {
    const BorderStates states =
        border_states(h, 0, Walls(surfaces, {1}, arrangement::make_box_sides(box)), box, within);
    const auto found = states.find({3, 2});
    return found == states.end() ? states.at({2, 3}) : found->second;
  };
  CHECK(state(right, 15) == BorderState::before_wall);  // the fault is 8 m before the edge
  CHECK(state(right, 5) == BorderState::open);
  CHECK(state(left, 15) == BorderState::met_wall);  // the horizon ends on the side of its own box
}
