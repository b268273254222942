// SPDX-License-Identifier: MIT
// The mesh while points are inserted into it by thousands: what is left alone stays as it was, what is made is valid.
#include <algorithm>
#include <catch2/catch.hpp>

#include "corpus_builder.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "refine_bench.hpp"
#include "remesh/domain/walled_mesh.hpp"

using namespace geomesh;
using namespace geomesh::remesh;
using namespace refine_models;

namespace {

using Listed = std::tuple<Tetrahedron, std::array<Index, 4>, std::array<CellIndex, 4>, Index, double>;

std::vector<Listed> listed(const DomainMesh& mesh) {
  std::vector<Listed> cells;
  for (const CellIndex c : mesh.live_cells()) {
    Listed cell{mesh.vertices(c), {}, {}, mesh.component(c), mesh.shape_of(c)};
    for (unsigned i = 0; i < 4; ++i) {
      const FaceTag tag = mesh.tag(c, i);
      std::get<1>(cell)[i] = tag.constrained() ? 2 * tag.facet() + (tag.above() ? 1 : 0) : no_index;
      std::get<2>(cell)[i] = mesh.has_neighbor(c, i) ? mesh.cells().neighbor_cell(c, i) : no_cell;
    }
    cells.push_back(cell);
  }
  return cells;
}

std::size_t n_faces_of_facets(const DomainMesh& mesh) {
  std::size_t n = 0;
  mesh.for_each_facet_face([&](FaceRef) { ++n; });
  return n;
}

}  // namespace

TEST_CASE("A mesh that is opened for insertions and closed again is the same", "[refine]") {
  Bench bench(ball_in_box(4));
  const std::vector<Listed> before = listed(bench.mesh);
  WalledMesh(bench.mesh).close(1);
  CHECK(listed(bench.mesh) == before);
  CHECK(bench.mesh.validate() == "");
}

TEST_CASE("Points inserted between walls leave walls, components and volume as they were", "[refine]") {
  for (Model model : {ball_in_box(4), two_boxes(3)}) {
    disturb_inside(model, 5);  // cells that are not Delaunay
    Bench bench(std::move(model));
    const double volume = bench.volume();
    const std::size_t n_faces = n_faces_of_facets(bench.mesh), n_cells = bench.mesh.n_cells();
    std::vector<Vec3> places;
    std::vector<CellIndex> homes;
    for (const CellIndex c : bench.mesh.live_cells())
      places.push_back(bench.mesh.middle(bench.mesh.vertices(c))), homes.push_back(c);
    WalledMesh walled(bench.mesh);
    std::size_t n = 0;
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (!walled.is_cell(homes[k])) continue;
      const auto home = walled.locate(places[k], homes[k]);
      if (home && walled.insert(places[k], *home, 1e-3)) ++n;
    }
    const std::size_t n_open = walled.n_cells();
    walled.close(2);
    CAPTURE(n_cells, n);
    CHECK(n > 50);
    CHECK(n_open == bench.mesh.n_cells());
    CHECK(bench.mesh.validate() == "");
    CHECK(bench.volume() == Approx(volume));
    CHECK(n_faces_of_facets(bench.mesh) == n_faces);
    for (const CellIndex c : bench.mesh.live_cells())
      REQUIRE(bench.mesh.shape_of(c) == bench.mesh.shape(bench.mesh.vertices(c)));
  }
}

TEST_CASE("A point is not inserted nearer to another than the spacing, and nothing is changed then", "[refine]") {
  Bench bench(two_boxes(3));
  const std::vector<Listed> before = listed(bench.mesh);
  const CellIndex c = *bench.mesh.live_cells().begin();
  const Vec3 p = bench.mesh.middle(bench.mesh.vertices(c));
  WalledMesh walled(bench.mesh);
  CHECK_FALSE(walled.insert(p, c, 10).has_value());
  walled.close(1);
  CHECK(listed(bench.mesh) == before);
}

TEST_CASE("The spacing holds where a cavity had to be reduced, too", "[refine]") {
  constexpr double spacing = 0.12;
  Model model = ball_in_box(6);
  disturb_inside(model, 5);  // cells that are not Delaunay, so that cavities are not star-shaped
  Bench bench(std::move(model));
  std::vector<std::pair<Vec3, CellIndex>> places;
  for (const CellIndex c : bench.mesh.live_cells()) {
    const auto corners = bench.mesh.places(bench.mesh.vertices(c));
    for (unsigned i = 0; i < 4; ++i)  // near corner i, inside of the cell
      places.emplace_back(0.7 * corners[i] + 0.1 * (corners[(i + 1) % 4] + corners[(i + 2) % 4] + corners[(i + 3) % 4]),
                          c);
  }
  WalledMesh walled(bench.mesh);
  std::size_t n = 0;
  for (const auto& [p, home] : places) {
    if (!walled.is_cell(home)) continue;
    const auto at = walled.locate(p, home);
    if (!at || !walled.insert(p, *at, spacing)) continue;
    ++n;
    for (const VertexIndex w : walled.link()) REQUIRE(distance(bench.mesh.point(w), p) >= spacing);
  }
  walled.close(1);
  CHECK(n > 20);
  CHECK(bench.mesh.validate() == "");
}

TEST_CASE("A point is connected with more vertices than the table of links has", "[refine]") {
  test::PlcBuilder builder;
  add_shell(builder, test::sphere({0, 0, 0}, 1, 3));  // 258 vertices, none of them inside
  Model model{builder.plc, tetrahedralize(builder.plc)};
  Bench bench(std::move(model));
  const double volume = bench.volume();
  const Vec3 p{1e-3, 2e-3, 3e-3};
  WalledMesh walled(bench.mesh);
  std::optional<CellIndex> home;
  for (CellIndex c = 0; c < walled.n_slots() && !home; ++c)
    if (walled.is_cell(c)) home = walled.locate(p, c);
  REQUIRE(home.has_value());
  REQUIRE(walled.insert(p, *home, 1e-3).has_value());
  const std::size_t n_linked = walled.link().size();
  walled.close(1);
  CHECK(n_linked > 64);
  CHECK(bench.mesh.validate() == "");
  CHECK(bench.volume() == Approx(volume));
}
