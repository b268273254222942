// SPDX-License-Identifier: GPL-3.0-or-later
// Triangulation in the plane: brute force, and agreement with the tetrahedra that stand on the plane.
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <set>
#include <vector>

#include "delaunay/constrained_triangulation.hpp"
#include "geomesh/core/delaunay.hpp"
#include "geomesh/core/planar_delaunay.hpp"
#include "geomesh/core/predicates.hpp"
#include "plc/facet_triangulation.hpp"

using namespace geomesh;

namespace {

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

namespace {

constexpr int n_across = 9, n_along = 7;

/// The points of a lattice within its border, which is the facet's loop.
FacetPolygon lattice_polygon(const std::vector<Vec3>& points) {
  const auto at = [&](int x, int y) {
    return static_cast<VertexIndex>(
        std::find_if(points.begin(), points.end(), [&](const Vec3& p) { return p.x == x && p.y == y; }) -
        points.begin());
  };
  FacetPolygon polygon;
  polygon.loops.resize(1);
  std::vector<VertexIndex>& loop = polygon.loops[0];
  for (int x = 0; x < n_across; ++x) loop.push_back(at(x, 0));
  for (int y = 1; y < n_along; ++y) loop.push_back(at(n_across - 1, y));
  for (int x = n_across - 2; x >= 0; --x) loop.push_back(at(x, n_along - 1));
  for (int y = n_along - 2; y > 0; --y) loop.push_back(at(0, y));
  for (int x = 1; x + 1 < n_across; ++x)
    for (int y = 1; y + 1 < n_along; ++y) polygon.inner_points.push_back(at(x, y));
  return polygon;
}

}  // namespace

TEST_CASE("A facet's draft equals the faces of the tetrahedra on its plane, ties included", "[delaunay]") {
  std::mt19937_64 random(9);
  for (const int slope : {0, 1, 2, -1}) {
    std::vector<Vec3> plane;
    for (int i = 0; i < n_across; ++i)
      for (int j = 0; j < n_along; ++j) plane.push_back({double(i), double(j), double(slope * (i - 2 * j))});
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
    FacetFault fault;
    const auto draft = triangulate_facet(plane, lattice_polygon(plane), fault);
    REQUIRE(draft);
    CHECK(draft->exactly_planar);
    std::set<Triangle> of_draft;
    for (Triangle t : draft->triangles) {
      std::sort(t.begin(), t.end());
      of_draft.insert(t);
    }
    CHECK(of_draft == on_plane);
  }
}

TEST_CASE("Segments are recovered in a plane by flips, and all other edges are Delaunay", "[delaunay]") {
  std::mt19937_64 random(5);
  for (unsigned round = 0; round < 40; ++round) {
    const unsigned side = round % 2 == 0 ? 12 : 1000;
    std::set<std::pair<unsigned, unsigned>> places;
    while (places.size() < 90) places.insert({random() % side, random() % side});
    std::vector<Vec3> points;
    for (const auto& [x, y] : places) points.push_back({double(x), double(y), 0});
    std::shuffle(points.begin(), points.end(), random);
    ConstrainedTriangulation plane(points, {});
    REQUIRE(plane.triangulate());
    std::vector<std::array<VertexIndex, 2>> inserted;
    std::size_t n_refused = 0;
    for (unsigned k = 0; k < 30; ++k) {
      const auto a = static_cast<VertexIndex>(random() % points.size()),
                 b = static_cast<VertexIndex>(random() % points.size());
      if (a == b) continue;
      if (plane.insert_constraint(a, b))
        ++n_refused;
      else
        inserted.push_back({a, b});
    }
    CHECK(inserted.size() > 3);
    CHECK(n_refused > 0);
    plane.restore_delaunay();
    const auto flat = [&](VertexIndex v) { return Vec2{points[v].x, points[v].y}; };
    for (const auto& e : inserted) CHECK((plane.apex(e[0], e[1]) || plane.apex(e[1], e[0])));
    const auto is_inserted = [&](VertexIndex a, VertexIndex b) {
      return std::any_of(inserted.begin(), inserted.end(),
                         [&](const auto& e) { return (e[0] == a && e[1] == b) || (e[0] == b && e[1] == a); });
    };
    for (VertexIndex a = 0; a < points.size(); ++a)
      for (VertexIndex b = 0; b < points.size(); ++b) {
        if (a == b) continue;
        const auto c = plane.apex(a, b), d = plane.apex(b, a);
        if (c) CHECK(orient2d(flat(a), flat(b), flat(*c)) == Sign::positive);
        if (!c || !d || is_inserted(a, b)) continue;
        CHECK(in_circle_perturbed(flat(a), flat(b), flat(*c), flat(*d)) == Sign::negative);
      }
  }
}

TEST_CASE("Points on one line have no triangulation in a plane", "[delaunay]") {
  CHECK_THROWS_AS(delaunay_triangulation(std::vector<Vec2>{{0, 0}, {1, 1}, {2, 2}}), Error);
  CHECK_FALSE(ConstrainedTriangulation(std::vector<Vec3>{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}, {}).triangulate());
  CHECK_FALSE(
      ConstrainedTriangulation(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}}, {}).triangulate());
}

TEST_CASE("A line through a plane triangulation crosses the edges that brute force finds, none where it meets a vertex",
          "[delaunay]") {
  std::mt19937_64 random(5);
  for (const unsigned side : {12u, 1000000u}) {  // a dozen: many points on the lines
    std::set<std::pair<double, double>> places;
    while (places.size() < 50) places.insert({double(random() % side), double(random() % side)});
    std::vector<Vec3> points;
    for (const auto& [x, y] : places) points.push_back({x, y, 0});
    ConstrainedTriangulation delaunay(points, {});
    REQUIRE(delaunay.triangulate());
    const auto turn = [&](VertexIndex a, VertexIndex b, VertexIndex c) {
      return orient2d({points[a].x, points[a].y}, {points[b].x, points[b].y}, {points[c].x, points[c].y});
    };
    const auto n = static_cast<VertexIndex>(points.size());
    std::vector<std::array<VertexIndex, 2>> edges;
    for (VertexIndex a = 0; a < n; ++a)
      for (VertexIndex b = a + 1; b < n; ++b)
        if (delaunay.apex(a, b) || delaunay.apex(b, a)) edges.push_back({a, b});
    for (VertexIndex a = 0; a < n; ++a)
      for (VertexIndex b = 0; b < n; ++b) {
        if (a == b) continue;
        bool meets_vertex = false;
        for (VertexIndex c = 0; c < n && !meets_vertex; ++c)
          meets_vertex =
              c != a && c != b && turn(a, b, c) == Sign::zero && dot(points[c] - points[a], points[c] - points[b]) < 0;
        std::size_t crossed = 0;
        for (const auto& [p, q] : edges)
          crossed += turn(a, b, p) * turn(a, b, q) == Sign::negative && turn(p, q, a) * turn(p, q, b) == Sign::negative;
        if (meets_vertex) crossed = 0;
        CHECK(delaunay.n_crossed(a, b, 1000) == crossed);
        if (!meets_vertex) CHECK(delaunay.n_crossed(a, b, 2) == std::min<std::size_t>(crossed, 2));
      }
  }
}
