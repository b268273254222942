// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "geomesh/geomodel/info.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

TriangulatedSurface tetrahedron_surface() {
  TriangulatedSurface s;
  s.name = "tet";
  s.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  s.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return s;
}

}  // namespace

TEST_CASE("info: a closed surface, its area and volume", "[info]") {
  const SurfaceInfo info = measure_surface(tetrahedron_surface());
  CHECK(info.closed);
  CHECK(info.volume == Approx(1.0 / 6).epsilon(1e-15));
  CHECK(info.area == Approx(1.5 + std::sqrt(3.0) / 2).epsilon(1e-15));
  CHECK(info.n_components == 1);
  CHECK(info.n_border_edges + info.n_non_manifold_edges + info.n_misoriented_edges + info.n_degenerate +
            info.n_repeated ==
        0);
}

TEST_CASE("info: every defect is counted", "[info]") {
  TriangulatedSurface s = tetrahedron_surface();
  s.triangles.pop_back();         // a border of three edges
  s.points.push_back({1, 0, 0});  // repeats point 1
  s.points.push_back({2, 0, 0});
  s.triangles.push_back({0, 4, 5});  // zero area
  s.triangles.push_back({0, 4, 3});  // repeats {0, 1, 3}: its edges now have three triangles
  const SurfaceInfo info = measure_surface(s);
  CHECK_FALSE(info.closed);
  CHECK(info.n_distinct_points == 5);
  CHECK(info.n_degenerate == 1);
  CHECK(info.n_repeated == 1);
  CHECK(info.n_borders == 1);
  CHECK(info.n_non_manifold_edges == 2);

  TriangulatedSurface turned = tetrahedron_surface();
  std::swap(turned.triangles[0][1], turned.triangles[0][2]);
  CHECK(measure_surface(turned).n_misoriented_edges == 3);
}
