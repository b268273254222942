// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "geomesh/core/delaunay.hpp"
#include "geomesh/core/validate.hpp"
#include "mesh/sorted_cells.hpp"

using namespace geomesh;

namespace {

std::vector<Vec3> random_points(std::size_t n) {
  std::mt19937_64 random(5);
  std::vector<Vec3> points;
  const auto coordinate = [&] { return static_cast<double>(random() % 1000); };
  for (std::size_t i = 0; i < n; ++i) points.push_back({coordinate(), coordinate(), coordinate()});
  return points;
}

std::vector<Tetrahedron> sorted_vertices(const TetMesh& mesh) {
  std::vector<Tetrahedron> out;
  for (CellIndex c = 0; c < mesh.n_slots(); ++c) {
    if (!mesh.is_live(c)) continue;
    Tetrahedron t = mesh.vertices(c);
    std::sort(t.begin(), t.end());
    out.push_back(t);
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

TEST_CASE("sorted cells are the same mesh, laid out the same way however it was made", "[delaunay]") {
  const std::vector<Vec3> points = random_points(500);
  const auto n = static_cast<VertexIndex>(points.size());
  const TetMesh by_cavities = delaunay_tetrahedralization(points).mesh;
  const TetMesh sorted = with_sorted_cells(by_cavities, n);
  CHECK(validate_topology(sorted).empty());
  CHECK(validate_geometry(sorted, points).empty());
  CHECK(sorted_vertices(sorted) == sorted_vertices(by_cavities));
  CHECK(sorted.n_live() == sorted.n_slots());
  for (CellIndex c = 1; c < sorted.n_slots(); ++c) CHECK(sorted.vertices(c - 1) < sorted.vertices(c));

  const TetMesh by_flips =
      with_sorted_cells(delaunay_tetrahedralization(points, {DelaunayAlgorithm::flip, 50}).mesh, n);
  REQUIRE(by_flips.n_slots() == sorted.n_slots());
  for (CellIndex c = 0; c < sorted.n_slots(); ++c) {
    CHECK(by_flips.vertices(c) == sorted.vertices(c));
    for (unsigned i = 0; i < 4; ++i) CHECK(by_flips.neighbor(c, i) == sorted.neighbor(c, i));
  }
}
