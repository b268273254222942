// SPDX-License-Identifier: GPL-3.0-or-later
// Horizons made from points on both sides of a fault.
#include <catch2/catch.hpp>
#include <cmath>

#include "geomesh/geomodel/ask_stack.hpp"
#include "geomesh/geomodel/gridding_in_blocks.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

constexpr double throw_at_fault = 300;

/// A plane west of the fault, and 300 m lower east of it, where it dips the other way.
double height(const Vec3& p, bool is_east) { return -1000 + (is_east ? -throw_at_fault - 0.05 * p.x : 0.02 * p.x); }

/// A fault through the box, at x = 2000 at the level of the horizon, that dips to the east.
TriangulatedSurface fault_sheet() {
  TriangulatedSurface f;
  f.name = "f";
  f.kind = SurfaceKind::fault;
  for (const double y : {-100.0, 4100.0})
    for (const double z : {100.0, -2100.0}) f.points.push_back({2000 + 0.5 * (-1150 - z), y, z});
  f.triangles = {{0, 1, 2}, {2, 1, 3}};
  return f;
}

bool is_east_of(const Vec3& p) { return p.x > 2000 + 0.5 * (-1150 - p.z); }

struct Model {
  std::vector<TriangulatedSurface> surfaces;
  PointsOfHorizons made;
  ModelRules rules;
};

/// `n_east` of the points lie east of the fault. The common surface passes through all of them. The box begins at
/// `west`.
Model model_with(std::size_t n_east, double west = 0) {
  Model m;
  GriddedPoints& points = m.made[1];
  for (const double x : {150.0, 700.0, 1300.0})
    for (const double y : {200.0, 2000.0, 3800.0}) points.points.push_back({x, y, height({x, y, 0}, false)});
  for (const double x : {2700.0, 3300.0, 3850.0})
    for (const double y : {200.0, 2000.0, 3800.0})
      if (points.points.size() < 9 + n_east) points.points.push_back({x, y, height({x, y, 0}, true)});
  GriddedSurface common = grid_points(points.points, points.spec, GraphOver::map, nullptr);
  points.spacing = common.spacing;
  common.surface.name = "h";
  common.surface.kind = SurfaceKind::horizon;
  m.surfaces = {fault_sheet(), std::move(common.surface)};
  m.rules.surfaces.resize(2);
  const Box3 box{{west, 0, -2000}, {4000, 4000, 0}};
  m.rules.box = box;
  m.rules.continue_within = 400;
  ModelVolume volume;
  volume.box = volume.bounds = box;
  ask_continuation(m.rules, RefinementSettings(), volume);
  return m;
}

/// How far the horizon is from the plane of the side on which its points lie.
double largest_error(const TriangulatedSurface& horizon) {
  double largest = 0;
  for (const Vec3& p : horizon.points) largest = std::max(largest, std::abs(p.z - height(p, is_east_of(p))));
  return largest;
}

}  // namespace

TEST_CASE("points on both sides of a fault give two planes, and the throw between them", "[gridding]") {
  Model m = model_with(9);
  REQUIRE(largest_error(m.surfaces[1]) > 50);  // the common surface climbs over the fault
  const std::vector<GriddedInBlocks> told = grid_in_blocks(m.surfaces, m.made, m.rules);
  REQUIRE(told.size() == 1);
  CHECK(told[0].row == 1);
  CHECK(told[0].n_blocks == 2);
  CHECK(told[0].n_in_common == 0);
  CHECK(std::abs(told[0].largest_residual) < 1e-6);
  CHECK(largest_error(m.surfaces[1]) < 1e-6);
  bool reaches_east = false, reaches_west = false;
  for (const Vec3& p : m.surfaces[1].points) (is_east_of(p) ? reaches_east : reaches_west) = true;
  CHECK(reaches_east);
  CHECK(reaches_west);
  for (const Triangle& t : m.surfaces[1].triangles)
    for (const VertexIndex v : t) CHECK(is_east_of(m.surfaces[1].points[v]) == is_east_of(m.surfaces[1].points[t[0]]));
}

TEST_CASE("a block with too few points keeps the common surface", "[gridding]") {
  Model m = model_with(3);
  const TriangulatedSurface common = m.surfaces[1];
  const std::vector<GriddedInBlocks> told = grid_in_blocks(m.surfaces, m.made, m.rules);
  REQUIRE(told.size() == 1);
  CHECK(told[0].n_blocks == 2);
  CHECK(told[0].n_in_common == 1);
  for (const Vec3& p : m.surfaces[1].points)
    if (!is_east_of(p)) CHECK(std::abs(p.z - height(p, false)) < 1e-6);
}

TEST_CASE("points outside of the box help to make the surface inside", "[gridding]") {
  Model m = model_with(9, 1000);  // the three western points that are inside lie on one line
  const std::vector<GriddedInBlocks> told = grid_in_blocks(m.surfaces, m.made, m.rules);
  REQUIRE(told.size() == 1);
  CHECK(told[0].n_in_common == 0);
  CHECK(largest_error(m.surfaces[1]) < 1e-6);
}

TEST_CASE("points in one block, and models without faults or continuation, keep their surfaces", "[gridding]") {
  const auto is_unchanged = [](Model m) {
    const TriangulatedSurface before = m.surfaces[1];
    return grid_in_blocks(m.surfaces, m.made, m.rules).empty() && m.surfaces[1].points == before.points;
  };
  CHECK(is_unchanged(model_with(0)));
  Model without_fault = model_with(9);
  without_fault.surfaces[0].triangles.clear();
  CHECK(is_unchanged(std::move(without_fault)));
  Model kept = model_with(9);
  kept.rules.continuation.within_of_horizons = 0;
  CHECK(is_unchanged(std::move(kept)));
}
