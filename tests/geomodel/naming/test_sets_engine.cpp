// SPDX-License-Identifier: GPL-3.0-or-later
// From soup through the engine to the named mesh.
#include <catch2/catch.hpp>

#include "geomesh/core/tetrahedralize.hpp"
#include "grid_model.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;

TEST_CASE("soups go through the engine to named meshes, with box sides as triangles and as polygons", "[sets]") {
  const GridModel grid = make_grid_model(
      {6, 4, 6}, {10, 10, 5},
      {plane("upper", SurfaceKind::horizon, 2, 4), plane("lower", SurfaceKind::horizon, 2, 2),
       plane("f", SurfaceKind::fault, 0, 4, [](int, int j, int k) { return j >= 1 && j <= 2 && k <= 1; })});
  for (const bool merge : {false, true}) {
    const ModelPlc plc = make_plc(grid.soup, grid.surfaces, {}, {merge});
    const ConstrainedTetrahedralization mesh = tetrahedralize(plc.plc);
    std::vector<std::string> warnings;
    const ModelMesh model = name_model({mesh, grid.soup, plc, grid.surfaces}, {}, three_layer_rules(), warnings);
    CHECK(validate_model_mesh(model) == std::vector<std::string>{});
    REQUIRE(model.regions.size() == 3);
    CHECK(model.regions[0].name == "top");
    for (const Region& r : model.regions) CHECK(r.volume == Approx(24000).epsilon(1e-13));
    for (const NamedSurface& s : model.surfaces) {
      if (s.name == "zmin" || s.name == "upper") CHECK(s.area == Approx(2400).epsilon(1e-13));
      if (s.name == "f") CHECK(s.area == Approx(50).epsilon(1e-13));
    }
    for (const auto& face : model.faces) {
      const NamedSurface& s = model.surfaces[static_cast<std::size_t>(face.surface - model.surfaces.front().id)];
      const auto row = static_cast<std::size_t>(&s - model.surfaces.data());
      const Triangle& source = grid.surfaces[row].triangles.at(static_cast<std::size_t>(face.source_triangle));
      if (merge || s.kind == SurfaceKind::box) continue;
      for (VertexIndex v : face.vertices)
        CHECK(std::find(source.begin(), source.end(), model.input_vertex[v]) != source.end());
    }
    double lengths = 0;
    for (const NamedCurve& c : model.curves)
      if (c.name == "f.tip") lengths += c.length;
    CHECK(lengths == Approx(20).epsilon(1e-13));
  }
}
