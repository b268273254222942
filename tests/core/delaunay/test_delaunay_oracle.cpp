// SPDX-License-Identifier: GPL-3.0-or-later
// The tetrahedra against CGAL's, which breaks ties by the same perturbation.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "geomesh/core/delaunay.hpp"
#include "geomesh/core/validate.hpp"

using namespace geomesh;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_3<VertexIndex, Kernel>;
using Oracle = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex>>;

std::vector<Tetrahedron> sorted_cells(std::vector<Tetrahedron> cells) {
  for (auto& c : cells) std::sort(c.begin(), c.end());
  std::sort(cells.begin(), cells.end());
  return cells;
}

std::vector<Tetrahedron> oracle_cells(const std::vector<Vec3>& points) {
  std::vector<std::pair<Kernel::Point_3, VertexIndex>> input;
  for (VertexIndex v = 0; v < points.size(); ++v)
    input.emplace_back(Kernel::Point_3(points[v].x, points[v].y, points[v].z), v);
  Oracle oracle(input.begin(), input.end());
  std::vector<Tetrahedron> cells;
  for (auto c = oracle.finite_cells_begin(); c != oracle.finite_cells_end(); ++c)
    cells.push_back({c->vertex(0)->info(), c->vertex(1)->info(), c->vertex(2)->info(), c->vertex(3)->info()});
  return sorted_cells(std::move(cells));
}

std::vector<Tetrahedron> our_cells(const std::vector<Vec3>& points) {
  const auto result = delaunay_tetrahedralization(points);
  CHECK(validate_topology(result.mesh).empty());
  CHECK(validate_geometry(result.mesh, points).empty());
  CHECK(validate_delaunay(result.mesh, points).empty());
  std::vector<Tetrahedron> cells;
  for (CellIndex c = 0; c < result.mesh.n_slots(); ++c)
    if (result.mesh.is_live(c) && !result.mesh.is_ghost(c)) cells.push_back(result.mesh.vertices(c));
  return sorted_cells(std::move(cells));
}

std::vector<Vec3> uniform(std::size_t n, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<Vec3> points(n);
  for (auto& p : points) p = {coordinate(random), coordinate(random), coordinate(random)};
  return points;
}

}  // namespace

TEST_CASE("Delaunay: random points give the oracle's tetrahedra", "[delaunay]") {
  for (const std::size_t n : {4u, 5u, 10u, 100u, 5000u}) {
    const auto points = uniform(n, static_cast<unsigned>(n));
    CHECK(our_cells(points) == oracle_cells(points));
  }
}

TEST_CASE("Delaunay: cospherical and coplanar lattices give the oracle's tetrahedra", "[delaunay]") {
  for (const int n : {2, 3, 6, 12}) {
    std::vector<Vec3> points;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        for (int k = 0; k < n; ++k) points.push_back({double(i), double(j), double(k)});
    std::shuffle(points.begin(), points.end(), std::mt19937_64(7));
    CHECK(our_cells(points) == oracle_cells(points));
  }
}
