// SPDX-License-Identifier: GPL-3.0-or-later
// Triangulation in the plane: brute force, and agreement with the tetrahedra that stand on the plane.
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <set>
#include <vector>

#include "geomesh/core/delaunay.hpp"
#include "geomesh/core/planar_delaunay.hpp"
#include "geomesh/core/predicates.hpp"

using namespace geomesh;

namespace {

std::set<Triangle> triangles(const TriMesh& mesh) {
  std::set<Triangle> r;
  for (CellIndex c = 0; c < mesh.n_slots(); ++c) {
    if (!mesh.is_live(c) || mesh.is_ghost(c)) continue;
    Triangle t = mesh.vertices(c);
    std::sort(t.begin(), t.end());
    r.insert(t);
  }
  return r;
}

void check_links(const TriMesh& mesh) {
  for (CellIndex c = 0; c < mesh.n_slots(); ++c)
    for (unsigned i = 0; i < 3; ++i) {
      const FaceRef n = mesh.neighbor(c, i);
      REQUIRE(mesh.mirror(n) == FaceRef(c, i));
      CHECK(mesh.vertex(c, (i + 1) % 3) == mesh.vertex(n.cell(), (n.face() + 2) % 3));
      CHECK(mesh.vertex(c, (i + 2) % 3) == mesh.vertex(n.cell(), (n.face() + 1) % 3));
    }
}

}  // namespace

TEST_CASE("planar Delaunay: every perturbed circle is empty and the hull is filled", "[delaunay]") {
  std::mt19937_64 random(3);
  for (const int side : {3, 7, 1000000}) {
    std::vector<Vec2> points;
    for (int i = 0; i < 150; ++i)
      points.push_back(
          {double(random() % static_cast<unsigned>(side)), double(random() % static_cast<unsigned>(side))});
    const auto result = delaunay_triangulation(points);
    check_links(result.mesh);
    for (CellIndex c = 0; c < result.mesh.n_slots(); ++c) {
      if (result.mesh.is_ghost(c)) continue;
      const auto& t = result.mesh.vertices(c);
      CHECK(orient2d(points[t[0]], points[t[1]], points[t[2]]) == Sign::positive);
      for (VertexIndex v = 0; v < points.size(); ++v)
        if (points[v] != points[t[0]] && points[v] != points[t[1]] && points[v] != points[t[2]])
          CHECK(in_circle_perturbed(points[t[0]], points[t[1]], points[t[2]], points[v]) == Sign::negative);
    }
  }
}

TEST_CASE("planar Delaunay: a facet's draft equals the faces of the tetrahedra on its plane, ties included",
          "[delaunay]") {
  std::mt19937_64 random(9);
  for (const int slope : {0, 1, 2}) {
    std::vector<Vec3> plane;
    for (int i = 0; i < 9; ++i)
      for (int j = 0; j < 7; ++j) plane.push_back({double(i), double(j), double(slope * (i - 2 * j))});
    std::shuffle(plane.begin(), plane.end(), random);
    std::vector<Vec3> all = plane;
    for (int k = 0; k < 40; ++k) {
      const double x = double(random() % 9), y = double(random() % 7);
      all.push_back({x + 0.5, y, slope * (x - 2 * y) + 20.0 + double(random() % 5)});
    }
    std::set<Triangle> on_plane;
    const auto volume = delaunay_tetrahedralization(all);
    for (CellIndex c = 0; c < volume.mesh.n_slots(); ++c) {
      if (volume.mesh.is_ghost(c)) continue;
      for (const auto& f : face_vertices) {
        Triangle t{volume.mesh.vertex(c, f[0]), volume.mesh.vertex(c, f[1]), volume.mesh.vertex(c, f[2])};
        std::sort(t.begin(), t.end());
        if (t[2] < plane.size()) on_plane.insert(t);
      }
    }
    CHECK(triangles(delaunay_triangulation_in_plane(plane).mesh) == on_plane);
  }
}

TEST_CASE("planar Delaunay: refusals", "[delaunay]") {
  CHECK_THROWS_AS(delaunay_triangulation(std::vector<Vec2>{{0, 0}, {1, 1}, {2, 2}}), Error);
  CHECK_THROWS_AS(delaunay_triangulation_in_plane(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1e-30}}),
                  Error);
}
