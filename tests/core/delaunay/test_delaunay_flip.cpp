// SPDX-License-Identifier: GPL-3.0-or-later
// The flip algorithm: the same tetrahedra as the cavity algorithm, no stuck face in insertion; flips from starts that
// are not Delaunay.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "delaunay/flip_insertion.hpp"
#include "geomesh/core/delaunay.hpp"
#include "geomesh/core/validate.hpp"

using namespace geomesh;

namespace {

std::vector<Vec3> points_of_kind(int kind, std::size_t n) {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<Vec3> points(n);
  for (std::size_t i = 0; i < n; ++i) {
    Vec3& p = points[i];
    p = {coordinate(random), coordinate(random), coordinate(random)};
    if (kind == 1) p = {double(random() % 9), double(random() % 9), double(random() % 9)};
    if (kind == 2) p = std::pow(10.0, -double(i % 8)) * p;
    if (kind == 3) p = (1 / std::sqrt(dot(p, p))) * p;
    if (kind == 4) p.z = i % 7 == 0 ? p.z : 0.25;  // most in one plane
    if (kind == 5) p = {double(random() % 5), double(random() % 40), 0.1 * double(random() % 3)};
  }
  return points;
}

std::vector<Tetrahedron> finite_cells(const TetMesh& mesh) {
  std::vector<Tetrahedron> cells;
  for (CellIndex c = 0; c < mesh.n_slots(); ++c)
    if (mesh.is_live(c) && !mesh.is_ghost(c)) {
      cells.push_back(mesh.vertices(c));
      std::sort(cells.back().begin(), cells.back().end());
    }
  std::sort(cells.begin(), cells.end());
  return cells;
}

}  // namespace

TEST_CASE("Delaunay: cavity and flip end in the same tetrahedra", "[delaunay]") {
  for (const int kind : {0, 1, 2, 3, 4, 5}) {
    const auto points = points_of_kind(kind, 4000);
    const auto cavity = delaunay_tetrahedralization(points);
    DelaunayOptions options;
    options.algorithm = DelaunayAlgorithm::flip;
    for (const double distance : {0.0, 0.05}) {
      options.cluster_distance = distance;
      const auto flip = delaunay_tetrahedralization(points, options);
      INFO("kind " << kind);
      CHECK(flip.statistics.stuck_faces == 0);
      CHECK(validate_topology(flip.mesh).empty());
      CHECK(validate_geometry(flip.mesh, points).empty());
      CHECK(validate_delaunay(flip.mesh, points).empty());
      CHECK(finite_cells(cavity.mesh) == finite_cells(flip.mesh));
      CHECK(cavity.representative == flip.representative);
    }
  }
}

TEST_CASE("Delaunay: flips from a start that is not Delaunay keep a valid mesh and count what is stuck", "[delaunay]") {
  std::size_t stuck_total = 0, clean = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    const VertexIndex n = 250;
    std::vector<PointRecord> records(n + 1);
    std::vector<Vec3> points{{-4, -4, -4}, {12, -4, -4}, {-4, 12, -4}, {-4, -4, 12}};
    while (points.size() < n) points.push_back({coordinate(random), coordinate(random), coordinate(random)});
    for (VertexIndex v = 0; v < n; ++v) static_cast<Vec3&>(records[v]) = points[v];
    TetMesh mesh;
    FlipInsertion flips(mesh, Space3(records.data(), n, 0), SlotSource(0, 0, 0, 1));
    flips.start({0, 1, 2, 3});
    for (VertexIndex v = 4; v < n; ++v) REQUIRE(flips.split_only(v) == InsertionOutcome::inserted);
    const std::size_t stuck = flips.flip_all();
    CHECK(flips.flips() > 0);
    flips.slots().finish(mesh);
    for (CellIndex c = 0; c < mesh.n_slots(); ++c)
      for (unsigned i = 0; i < 4; ++i)
        if (mesh.vertex(c, i) == n) mesh.set_vertex(c, i, infinite_vertex);
    CHECK(validate_topology(mesh).empty());
    CHECK(validate_geometry(mesh, points).empty());
    // Locally Delaunay everywhere just where nothing is stuck; then the mesh is the one that insertion gives.
    CHECK(validate_delaunay(mesh, points).empty() == (stuck == 0));
    if (stuck == 0) CHECK(finite_cells(mesh) == finite_cells(delaunay_tetrahedralization(points).mesh));
    stuck_total += stuck;
    clean += stuck == 0;
  }
  INFO("flips from split-only starts: " << clean << " of 20 reach Delaunay, " << stuck_total
                                        << " faces stuck in the others");
  CHECK(clean > 0);
}

TEST_CASE("Delaunay: make_delaunay mends starts tangled by flips at random", "[delaunay]") {
  std::size_t n_stuck = 0;
  for (unsigned seed = 0; seed < 30; ++seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    const VertexIndex n = 40;
    std::vector<Vec3> points;
    std::vector<PointRecord> records(n + 1);
    while (points.size() < n) points.push_back({coordinate(random), coordinate(random), coordinate(random)});
    for (VertexIndex v = 0; v < n; ++v) static_cast<Vec3&>(records[v]) = points[v];
    const auto expected = delaunay_tetrahedralization(points);
    TetMesh mesh = expected.mesh;
    for (CellIndex c = 0; c < mesh.n_slots(); ++c)
      for (unsigned i = 0; i < 4; ++i)
        if (mesh.vertex(c, i) == infinite_vertex) {
          mesh.set_vertex(c, i, n);
          mesh.flags(c) = FlipInsertion::ghost_flag;
        }
    SlotSource slots;
    slots.restart(mesh.n_slots(), mesh.n_slots());
    FlipInsertion tangle(mesh, Space3(records.data(), n, 0), slots);
    for (int k = 0; k < 3000; ++k) {
      const auto c = static_cast<CellIndex>(random() % mesh.n_slots());
      const bool used = mesh.is_live(c) && c < tangle.slots().used_end();
      const auto unused = tangle.slots().unused(mesh.n_slots());
      if (used && std::find(unused.begin(), unused.end(), c) == unused.end())
        tangle.flip_face(FaceRef(c, random() % 4));
    }
    tangle.slots().finish(mesh);
    for (CellIndex c = 0; c < mesh.n_slots(); ++c)
      for (unsigned i = 0; i < 4; ++i)
        if (mesh.vertex(c, i) == n) mesh.set_vertex(c, i, infinite_vertex);
    REQUIRE(validate_topology(mesh).empty());
    REQUIRE(validate_geometry(mesh, points).empty());
    REQUIRE_FALSE(validate_delaunay(mesh, points).empty());
    n_stuck += make_delaunay(mesh, points) > 0;
    CHECK(validate_topology(mesh).empty());
    CHECK(validate_delaunay(mesh, points).empty());
    CHECK(finite_cells(mesh) == finite_cells(expected.mesh));
  }
  CHECK(n_stuck < 30);
}

// An affine map keeps every cell positive, so the cells that are Delaunay for stretched points are a valid mesh of the
// points themselves, far from Delaunay: from such starts flips do get stuck.
TEST_CASE("Delaunay: make_delaunay mends starts from which flips get stuck", "[delaunay]") {
  std::size_t n_stuck = 0, n_flipped = 0;
  for (unsigned seed = 0; seed < 12; ++seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    std::vector<Vec3> points(300), stretched;
    for (Vec3& p : points) p = {coordinate(random), coordinate(random), coordinate(random)};
    for (const Vec3& p : points) stretched.push_back({p.x + 3 * p.y, p.y, 3 * p.z});
    TetMesh mesh = delaunay_tetrahedralization(stretched).mesh;
    REQUIRE(validate_geometry(mesh, points).empty());
    REQUIRE_FALSE(validate_delaunay(mesh, points).empty());
    (make_delaunay(mesh, points) > 0 ? n_stuck : n_flipped) += 1;
    CHECK(validate_topology(mesh).empty());
    CHECK(validate_geometry(mesh, points).empty());
    CHECK(validate_delaunay(mesh, points).empty());
    CHECK(finite_cells(mesh) == finite_cells(delaunay_tetrahedralization(points).mesh));
  }
  CHECK(n_stuck > 0);
  CHECK(n_flipped > 0);
}
