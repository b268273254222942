// SPDX-License-Identifier: GPL-3.0-or-later
// Held against a look at every tetrahedron.
#include <catch2/catch.hpp>
#include <random>

#include "geomesh/core/delaunay.hpp"
#include "geomesh/core/predicates.hpp"
#include "naming/sums.hpp"
#include "rules/framework/tetrahedron_search.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

bool holds(const std::array<Vec3, 4>& t, const Vec3& p) {
  constexpr std::array<std::array<std::size_t, 4>, 4> order{{{0, 1, 2, 3}, {0, 3, 1, 2}, {1, 3, 2, 0}, {0, 2, 3, 1}}};
  for (const auto& [a, b, c, d] : order)
    if (orient3d(t[a], t[b], t[c], p) == -orient3d(t[a], t[b], t[c], t[d])) return false;
  return true;
}

void agrees_with_all(const std::vector<Vec3>& points, const std::vector<Tetrahedron>& tetrahedra,
                     const std::vector<Vec3>& places) {
  const TetrahedronSearch search(points, tetrahedra);
  Index last = no_index;
  for (const Vec3& p : places) {
    Index first = no_index;
    for (Index t = 0; t < tetrahedra.size() && first == no_index; ++t)
      if (holds(search.corners(t), p)) first = t;
    CHECK(search.find(p, no_index) == first);
    CHECK(search.find(p, last) == first);
    if (first != no_index) last = first;
  }
}

std::vector<Tetrahedron> hull_of(const std::vector<Vec3>& points) {
  const TetMesh mesh = delaunay_tetrahedralization(points).mesh;
  std::vector<Tetrahedron> cells;
  for (CellIndex c = 0; c < mesh.n_slots(); ++c)
    if (mesh.is_live(c) && !mesh.is_ghost(c)) cells.push_back(mesh.vertices(c));
  return cells;
}

/// A turned box of 4 by 4 by 4 points.
std::vector<Vec3> turned_lattice() {
  std::vector<Vec3> points;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 4; ++k) points.push_back({0.8 * i - 0.6 * j, 0.6 * i + 0.8 * j, 1.0 * k});
  return points;
}

}  // namespace

TEST_CASE("a place is found in the first tetrahedron that holds it", "[framework]") {
  const std::vector<Vec3> points = turned_lattice();
  const std::vector<Tetrahedron> tetrahedra = hull_of(points);
  std::vector<Vec3> places = points;  // corners, middles of edges, and places inside and outside
  for (const Tetrahedron& t : tetrahedra) places.push_back(0.5 * (points[t[0]] + points[t[1]]));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> from(-4, 6);
  for (int k = 0; k < 300; ++k) places.push_back({from(random), from(random), from(random)});
  agrees_with_all(points, tetrahedra, places);
}

TEST_CASE("a place is found in a mesh with a bay", "[framework]") {
  const std::vector<Vec3> points = turned_lattice();
  std::vector<Tetrahedron> tetrahedra;
  const std::vector<Tetrahedron> all = hull_of(points);
  for (const Tetrahedron& t : all) {
    const Vec3 centre = 0.25 * (points[t[0]] + points[t[1]] + points[t[2]] + points[t[3]]);
    if (norm(centre - Vec3{0, 2, 2}) > 1.2) tetrahedra.push_back(t);
  }
  REQUIRE(tetrahedra.size() < all.size());
  std::vector<Vec3> places;
  std::mt19937 random(8);
  std::uniform_real_distribution<double> from(-3, 5);
  for (int k = 0; k < 300; ++k) places.push_back({from(random), from(random), from(random)});
  agrees_with_all(points, tetrahedra, places);
}
