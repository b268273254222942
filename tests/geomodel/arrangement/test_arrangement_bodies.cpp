// SPDX-License-Identifier: GPL-3.0-or-later
// What is brought to a body and cut off with what is inside of it.
#include <catch2/catch.hpp>

#include "arrangement/model/ingest.hpp"
#include "arrangement_inputs.hpp"
#include "require_sound.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;

namespace {

TriangulatedSurface salt() {
  TriangulatedSurface body;
  body.name = "salt";
  body.kind = SurfaceKind::body;
  body.cuts_all = true;
  for (const TriangulatedSurface& side : arrangement::make_box_sides(Box3{{0, 0, 0}, {10, 10, 10}}))
    for (const Triangle& t : side.triangles) {
      for (const VertexIndex v : t) body.points.push_back(side.points[v]);
      const auto n = static_cast<VertexIndex>(body.points.size());
      body.triangles.push_back({n - 3, n - 2, n - 1});
    }
  return body;
}

/// All but parallel to the side x = 10, with a corner beyond it and a part that is far from it.
TriangulatedSurface fault(double beyond) {
  auto surface = triangles("fault", {{Vec3{9.9, 2, 5}, Vec3{10 + beyond, 5, 5}, Vec3{9, 5, 9}},
                                     {Vec3{10 + beyond, 5, 5}, Vec3{9.9, 8, 5}, Vec3{9, 5, 9}},
                                     {Vec3{14, 5, 5}, Vec3{15, 6, 5}, Vec3{14, 5, 6}}});
  surface.kind = SurfaceKind::fault;
  return surface;
}

ArrangementResult arranged_within(double tolerance, double beyond) {
  ArrangementOptions options;
  options.tolerance = tolerance;
  auto result = arrange({salt(), fault(beyond)}, {}, {}, options);
  require_sound(result.soup);
  return result;
}

}  // namespace

TEST_CASE("bodies: how far from a fault what was brought into a body is, is told as a move", "[arrangement]") {
  constexpr double beyond = 0.004, far = 4 - beyond, area_far = 0.70710678;
  const auto apart = arranged_within(0, beyond);
  CHECK(area_of(apart.soup, 1) > area_far + 1e-5);
  CHECK(apart.merging.displacement.largest == 0);
  const auto together = arranged_within(0.01, beyond);
  CHECK(area_of(together.soup, 1) == Approx(area_far));
  CHECK(together.merging.displacement.largest == Approx(far).epsilon(0.01));
}

TEST_CASE("bodies: a border that leaves a body at a small angle is told as moved as far as it goes", "[arrangement]") {
  constexpr double beyond = 0.008, from = 8;  // the border is within 0.01 of the side and beyond it from y = 4 on
  auto horizon = triangles("horizon", {{Vec3{9.996, 2, 5}, Vec3{10 + beyond, from, 5}, Vec3{5, 5, 5}},
                                       {Vec3{10 + beyond, from, 5}, Vec3{14, from, 5}, Vec3{14, 9, 5}}});
  horizon.kind = SurfaceKind::horizon;
  ArrangementOptions options;
  options.tolerance = 0.01;
  const auto result = arrange({salt(), horizon}, {}, {}, options);
  require_sound(result.soup);
  CHECK(area_of(result.soup, 1) == Approx(0.5 * (4 - beyond)));
  CHECK(result.merging.displacement.largest > 3);
  CHECK(result.merging.displacement.largest < 4);
}

TEST_CASE("bodies: what was inside, or is still there, is not told as lost", "[arrangement]") {
  CHECK(arranged_within(0.01, -0.02).merging.displacement.largest == 0);
  CHECK(arranged_within(0.01, 0.02).merging.displacement.largest < 0.01);
}
