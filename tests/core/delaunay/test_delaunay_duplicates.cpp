// SPDX-License-Identifier: GPL-3.0-or-later
// Equal points, and inputs without volume.
#include <catch2/catch.hpp>
#include <random>
#include <set>
#include <vector>

#include "geomesh/core/delaunay.hpp"
#include "geomesh/core/validate.hpp"

using namespace geomesh;

TEST_CASE("Delaunay: equal points stand for the first of them", "[delaunay]") {
  std::mt19937_64 random(11);
  std::vector<Vec3> points;
  for (int i = 0; i < 3000; ++i) points.push_back({double(random() % 8), double(random() % 8), double(random() % 8)});
  points.push_back({-0.0, 0.0, 0.0});
  points.push_back({0.0, -0.0, 0.0});
  const auto result = delaunay_tetrahedralization(points);
  REQUIRE(result.representative.size() == points.size());
  std::set<VertexIndex> expected, used;
  for (VertexIndex i = 0; i < points.size(); ++i) {
    VertexIndex first = 0;
    while (!(points[first] == points[i])) ++first;
    CHECK(result.representative[i] == first);
    expected.insert(first);
  }
  for (CellIndex c = 0; c < result.mesh.n_slots(); ++c)
    for (const VertexIndex v : result.mesh.vertices(c))
      if (v != infinite_vertex) used.insert(v);
  CHECK(used == expected);
  CHECK(validate_topology(result.mesh).empty());
  CHECK(validate_delaunay(result.mesh, points).empty());
}

TEST_CASE("Delaunay: inputs without volume and unsafe coordinates get an answer", "[delaunay]") {
  const auto kind_of = [](const std::vector<Vec3>& points) {
    try {
      delaunay_tetrahedralization(points);
    } catch (const Error& e) {
      return std::pair(e.kind(), std::string(e.what()));
    }
    return std::pair(ErrorKind::usage, std::string("no error"));
  };
  std::vector<Vec3> plane, line;
  for (int i = 0; i < 500; ++i) {
    plane.push_back({0.1 * (i % 23), 0.3 * (i / 23), 0});
    line.push_back({double(i), 2.0 * i, 3.0 * i});
  }
  CHECK(kind_of(plane) == std::pair(ErrorKind::cannot_mesh,
                                    std::string("all points lie in one plane: there is no volume to triangulate")));
  CHECK(kind_of(line) == std::pair(ErrorKind::cannot_mesh,
                                   std::string("all points lie on one line: there is no volume to triangulate")));
  CHECK(kind_of({{1, 1, 1}, {1, 1, 1}}).first == ErrorKind::cannot_mesh);
  CHECK(kind_of({}).first == ErrorKind::cannot_mesh);
  CHECK(kind_of({{1, 1, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1e-300, 1}}).first == ErrorKind::invalid_input);
  CHECK(kind_of({{1, 1, 1}, {0, 0, 0}, {1, 0, 0}, {0, std::numeric_limits<double>::quiet_NaN(), 1}}).first ==
        ErrorKind::invalid_input);
}
