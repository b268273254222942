// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "geomesh/core/error.hpp"
#include "grid_model.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;

namespace {

struct Named {
  ModelMesh model;
  std::vector<std::string> warnings;
};

Named name_grid(GridModel grid, const NamingRules& rules) {
  const ModelPlc plc = make_plc(grid.soup, grid.surfaces, {}, {false});
  add_segment_edges(plc, grid.mesh);
  Named named;
  named.model = name_model({grid.mesh, grid.soup, plc, grid.surfaces}, {}, rules, named.warnings);
  INFO((named.warnings.empty() ? std::string() : named.warnings.front()));
  CHECK(validate_model_mesh(named.model) == std::vector<std::string>{});
  return named;
}

std::vector<std::string> region_names(const ModelMesh& model) {
  std::vector<std::string> names;
  for (const Region& r : model.regions) names.push_back(r.name);
  return names;
}

double volume_of(const ModelMesh& model, const std::string& name) {
  for (const Region& r : model.regions)
    if (r.name == name) return r.volume;
  return -1;
}

bool some_warning_has(const std::vector<std::string>& warnings, const std::vector<std::string>& words) {
  return std::any_of(warnings.begin(), warnings.end(), [&](const std::string& w) {
    return std::all_of(words.begin(), words.end(),
                       [&](const std::string& word) { return w.find(word) != std::string::npos; });
  });
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("regions of a layer cake take the units of the column, youngest first, whatever the horizons' orientation",
          "[sets]") {
  for (const bool reversed : {false, true}) {
    GridSurface upper = plane("upper", SurfaceKind::horizon, 2, 2);
    upper.reversed = reversed;
    const Named named =
        name_grid(make_grid_model({2, 2, 3}, {1, 1, 1}, {upper, plane("lower", SurfaceKind::horizon, 2, 1)}),
                  three_layer_rules());
    CHECK(region_names(named.model) == Names{"top", "middle", "bottom"});
    CHECK(named.warnings.empty());
    for (const Region& r : named.model.regions) CHECK(r.volume == 4.0);
    CHECK(named.model.surfaces.front().id == 4);
    CHECK(named.model.surfaces[0].area == 4.0);
    for (const auto& face : named.model.faces) {
      if (face.surface != named.model.surfaces[0].id) continue;
      CHECK((face.region_minus == 1 && face.region_plus == 2));  // from top to middle: downwards
      const auto& p = named.model.points;
      CHECK(cross(p[face.vertices[1]] - p[face.vertices[0]], p[face.vertices[2]] - p[face.vertices[0]]).z < 0);
    }
  }
}

TEST_CASE("a fault cuts units into blocks with suffixes by place", "[sets]") {
  const Named named =
      name_grid(make_grid_model({2, 1, 2}, {1, 1, 1},
                                {plane("base", SurfaceKind::horizon, 2, 1), plane("f", SurfaceKind::fault, 0, 1)}),
                {{"sand", "base", "shale"}, {}, {}});
  CHECK(region_names(named.model) == Names{"sand__1", "sand__2", "shale__1", "shale__2"});
  CHECK(named.warnings.empty());  // faults do that
  for (const auto& face : named.model.faces)
    if (face.surface == named.model.surfaces[1].id) CHECK(face.region_minus + 1 == face.region_plus);
}

TEST_CASE("a hole in a horizon and a border that stops short join units, and the warning says which and where",
          "[sets]") {
  SECTION("hole") {
    const auto ring = [](int i, int j, int) { return i <= 1 || i >= 4 || j <= 1 || j >= 4; };
    const Named named = name_grid(
        make_grid_model({5, 5, 3}, {1, 1, 1},
                        {plane("upper", SurfaceKind::horizon, 2, 2, ring), plane("lower", SurfaceKind::horizon, 2, 1)}),
        three_layer_rules());
    CHECK(region_names(named.model) == Names{"top+middle", "bottom"});
    CHECK(some_warning_has(named.warnings, {"upper has a hole", "(2.5, 2.5, 2)", "top and middle join"}));
  }
  SECTION("stops short") {
    const Named named =
        name_grid(make_grid_model({3, 2, 3}, {1, 1, 1},
                                  {plane("upper", SurfaceKind::horizon, 2, 2),
                                   plane("lower", SurfaceKind::horizon, 2, 1, [](int i, int, int) { return i <= 2; })}),
                  three_layer_rules());
    CHECK(region_names(named.model) == Names{"top", "middle+bottom"});
    CHECK(some_warning_has(named.warnings, {"lower stops short", "middle and bottom join"}));
  }
  SECTION("an overshoot behind a fault is a flap, not a join") {
    const Named named = name_grid(make_grid_model({4, 1, 4}, {1, 1, 1},
                                                  {plane("f", SurfaceKind::fault, 0, 2),
                                                   {"h", SurfaceKind::horizon,
                                                    [](const auto& v) {
                                                      const auto in = [&](int k, int from, int to) {
                                                        return std::all_of(v.begin(), v.end(), [&](const auto& g) {
                                                          return g[2] == k && g[0] >= from && g[0] <= to;
                                                        });
                                                      };
                                                      return in(1, 0, 2) || in(3, 1, 4);
                                                    }}}),
                                  {{"sand", "h", "shale"}, {}, {}});
    CHECK(region_names(named.model) == Names{"sand__1", "sand__2", "shale__1", "shale__2"});
    CHECK(some_warning_has(named.warnings, {"h stops short", "ends there inside region sand__1"}));
  }
}

TEST_CASE("a horizon missing in a block, a pocket of crossing horizons and a block without horizons are told",
          "[sets]") {
  SECTION("missing") {
    const Named named =
        name_grid(make_grid_model({2, 1, 3}, {1, 1, 1},
                                  {plane("f", SurfaceKind::fault, 0, 1), plane("upper", SurfaceKind::horizon, 2, 2),
                                   plane("lower", SurfaceKind::horizon, 2, 1, [](int i, int, int) { return i <= 1; })}),
                  three_layer_rules());
    CHECK(region_names(named.model) == Names{"top__1", "top__2", "middle__1", "middle__2", "bottom"});
    CHECK(some_warning_has(named.warnings, {"could be middle to bottom", "no face of lower", "named middle"}));
  }
  SECTION("pocket") {
    // `upper` dips below `lower` in the left half.
    const auto step = [](int left, int right) {
      return [=](const std::array<std::array<int, 3>, 3>& v) {
        const auto all = [&](auto holds) { return std::all_of(v.begin(), v.end(), holds); };
        return all([&](const auto& g) { return g[2] == left && g[0] <= 1; }) ||
               all([&](const auto& g) { return g[2] == right && g[0] >= 1; }) || all([&](const auto& g) {
                 return g[0] == 1 && g[2] >= std::min(left, right) && g[2] <= std::max(left, right);
               });
      };
    };
    const Named named = name_grid(
        make_grid_model({2, 1, 4}, {1, 1, 1},
                        {{"upper", SurfaceKind::horizon, step(1, 3)}, {"lower", SurfaceKind::horizon, step(2, 2)}}),
        three_layer_rules());
    CHECK(some_warning_has(named.warnings, {"thin void below lower and above upper", "named top"}));
    CHECK(volume_of(named.model, "top__1") + volume_of(named.model, "top__2") == 4.0);
  }
  SECTION("no horizon") {
    const Named named =
        name_grid(make_grid_model({2, 1, 2}, {1, 1, 1},
                                  {plane("f", SurfaceKind::fault, 0, 1),
                                   plane("base", SurfaceKind::horizon, 2, 1, [](int i, int, int) { return i <= 1; })}),
                  {{"sand", "base", "shale"}, {}, {}});
    CHECK(region_names(named.model) == Names{"sand", "shale", "region_1"});
    CHECK(some_warning_has(named.warnings, {"touches no horizon"}));
  }
  SECTION("between faults, with a horizon further up") {
    const Named named =
        name_grid(make_grid_model({1, 1, 3}, {1, 1, 1},
                                  {plane("f", SurfaceKind::fault, 2, 1), plane("base", SurfaceKind::horizon, 2, 2)}),
                  {{"sand", "base", "shale"}, {}, {}});
    CHECK(region_names(named.model) == Names{"sand", "shale__1", "shale__2"});
    CHECK(some_warning_has(named.warnings, {"touches no horizon", "named shale", "on the vertical"}));
  }
}

TEST_CASE("bodies name what they hold, the innermost first, and every region knows the bodies it lies in", "[sets]") {
  const auto shell = [](std::string name, int lo, int hi) {
    return GridSurface{std::move(name), SurfaceKind::body, [=](const auto& v) {
                         for (std::size_t axis = 0; axis < 3; ++axis)
                           for (int at : {lo, hi})
                             if (std::all_of(v.begin(), v.end(), [&](const auto& g) {
                                   return g[axis] == at && *std::min_element(g.begin(), g.end()) >= lo &&
                                          *std::max_element(g.begin(), g.end()) <= hi;
                                 }))
                               return true;
                         return false;
                       }};
  };
  GridModel grid = make_grid_model({5, 5, 5}, {1, 1, 1}, {shell("salt", 1, 4), shell("core", 2, 3)});
  // Outward normals: the fixture stores them along the axes, so faces on the low sides turn round.
  for (std::size_t s = 0; s < 2; ++s) {
    const double middle = 2.5;
    for (Index t = 0; t < grid.surfaces[s].triangles.size(); ++t) {
      Triangle& v = grid.surfaces[s].triangles[t];
      const auto& p = grid.surfaces[s].points;
      const Vec3 normal = cross(p[v[1]] - p[v[0]], p[v[2]] - p[v[0]]);
      if (dot(normal, p[v[0]] - Vec3{middle, middle, middle}) > 0) continue;
      std::swap(v[1], v[2]);
      for (auto& o : grid.soup.origins)
        if (o.surface == s && o.triangle == t) o.reversed = !o.reversed;
    }
  }
  const Named named = name_grid(grid, {{"rock"}, {}, {}});
  CHECK(region_names(named.model) == Names{"rock", "salt", "core"});
  CHECK(named.model.regions[1].inside == Names{"salt"});
  CHECK(named.model.regions[2].inside == Names{"salt", "core"});
  CHECK(volume_of(named.model, "salt") == 26.0);
  CHECK(volume_of(named.model, "core") == 1.0);
}

TEST_CASE("hints and seeds name regions; what is left is numbered by first input triangle", "[sets]") {
  GridModel grid = three_layers(1);
  RegionHint hint{"reservoir", {}};
  for (Index t = 0; t < grid.surfaces[0].triangles.size(); ++t) hint.boundary.push_back({0, t, true});  // below `upper`
  for (Index t = 0; t < grid.surfaces[1].triangles.size(); ++t) hint.boundary.push_back({1, t, false});
  CHECK(region_names(name_grid(grid, {{}, {hint}, {}}).model) == Names{"reservoir", "region_1", "region_2"});
  grid.mesh.component_seed[grid.mesh.component.front()] = 0;
  CHECK(region_names(name_grid(grid, {{}, {hint}, {"seeded"}}).model) == Names{"reservoir", "seeded", "region_1"});
  CHECK(region_names(name_grid(three_layers(1), {}).model) == Names{"region_1", "region_2", "region_3"});
}

TEST_CASE("a column that is malformed or names no surface is refused", "[sets]") {
  CHECK_THROWS_AS(name_grid(three_layers(1), {{"a", "upper"}, {}, {}}), Error);
  CHECK_THROWS_AS(name_grid(three_layers(1), {{"a", "nowhere", "b"}, {}, {}}), Error);
}

TEST_CASE("a fault inside one region keeps its orientation and its tip is a curve", "[sets]") {
  const Named named =
      name_grid(make_grid_model({4, 2, 4}, {1, 1, 1},
                                {plane("f", SurfaceKind::fault, 0, 2, [](int, int, int k) { return k >= 2; })}),
                {{"rock"}, {}, {}});
  const std::int32_t f = named.model.surfaces[0].id;
  std::size_t n = 0;
  for (const auto& face : named.model.faces) {
    if (face.surface != f) continue;
    ++n;
    CHECK((face.region_minus == 1 && face.region_plus == 1));
    const auto& p = named.model.points;
    CHECK(cross(p[face.vertices[1]] - p[face.vertices[0]], p[face.vertices[2]] - p[face.vertices[0]]).x > 0);
  }
  CHECK(n == 8);
  const auto tip = std::find_if(named.model.curves.begin(), named.model.curves.end(),
                                [](const auto& c) { return c.kind == "fault_tip"; });
  REQUIRE(tip != named.model.curves.end());
  CHECK(tip->name == "f.tip");
  CHECK(tip->length == 2.0);
}

TEST_CASE("the validator of named meshes sees each kind of fault", "[sets]") {
  GridModel grid = three_layers(1);
  const ModelMesh good = name_grid(grid, three_layer_rules()).model;
  const auto faulty = [&](auto&& spoil) {
    ModelMesh bad = good;
    spoil(bad);
    return !validate_model_mesh(bad).empty();
  };
  CHECK(faulty([](ModelMesh& m) { std::swap(m.tetrahedra[0][0], m.tetrahedra[0][1]); }));
  CHECK(faulty([](ModelMesh& m) {
    m.tetrahedra.push_back(m.tetrahedra[0]);
    m.tet_region.push_back(m.tet_region[0]);
    ++m.regions[2].n_tetrahedra;
  }));
  CHECK(faulty([](ModelMesh& m) {
    m.points.push_back({9, 9, 9});
    m.point_kind.push_back(0);
    m.input_vertex.push_back(-1);
  }));
  CHECK(faulty([](ModelMesh& m) { m.points[0] = m.points[1]; }));
  CHECK(faulty([](ModelMesh& m) { m.faces.pop_back(); }));
  CHECK(faulty([](ModelMesh& m) { m.faces.push_back(m.faces[0]); }));
  CHECK(faulty([](ModelMesh& m) { std::swap(m.faces[0].vertices[0], m.faces[0].vertices[1]); }));
  CHECK(faulty([](ModelMesh& m) { m.tet_region[0] = 7; }));
  CHECK(faulty([](ModelMesh& m) { m.surfaces[0].id = 1; }));
  CHECK(faulty([](ModelMesh& m) {
    m.curve_edges.push_back({0, static_cast<VertexIndex>(m.points.size() - 1), m.curves[0].id});
  }));
  CHECK(faulty([](ModelMesh& m) { m.curve_edges.pop_back(); }));
  CHECK(faulty([](ModelMesh& m) { ++m.faces[0].patch; }));
  CHECK(faulty([](ModelMesh& m) { m.regions[0].name = m.regions[1].name; }));
  CHECK(faulty([](ModelMesh& m) { m.surface_sets[0] = {}; }));
}

TEST_CASE("units are named by fault block on wish, blocks ordered by place", "[sets]") {
  NamingRules rules = three_layer_rules();
  rules.fault_blocks = true;
  const Named one = name_grid(three_layers(1), rules);
  CHECK(region_names(one.model) == Names{"top", "middle", "bottom"});
  const Named two =
      name_grid(make_grid_model({2, 1, 3}, {1, 1, 1},
                                {plane("upper", SurfaceKind::horizon, 2, 2), plane("lower", SurfaceKind::horizon, 2, 1),
                                 plane("f", SurfaceKind::fault, 0, 1)}),
                rules);
  CHECK(region_names(two.model) == Names{"top__B1", "top__B2", "middle__B1", "middle__B2", "bottom__B1", "bottom__B2"});
  CHECK(two.model.regions[1].unit == "top");
  CHECK(two.model.points[two.model.tetrahedra[0][0]].x <= 1);
}

TEST_CASE("seed points give names; groups and attributes follow units and regions", "[sets]") {
  NamingRules rules = three_layer_rules();
  rules.seeds = {{"aquifer", {0.5, 0.5, 1.5}}, {"again", {0.6, 0.5, 1.5}}, {"nowhere", {9, 9, 9}}};
  rules.groups = {{"cover", {"top", "aquifer"}}, {"odd", {"no_such_unit"}}};
  rules.attributes = {{"top", {{"porosity", 0.3}}}, {"aquifer", {{"porosity", 0.2}, {"density", 2500}}}};
  const Named named = name_grid(three_layers(1), rules);
  CHECK(region_names(named.model) == Names{"top", "bottom", "aquifer"});
  CHECK(some_warning_has(named.warnings, {"aquifer and again lie in one region"}));
  CHECK(some_warning_has(named.warnings, {"nowhere", "outside of all regions"}));
  CHECK(some_warning_has(named.warnings, {"group odd names no_such_unit"}));
  REQUIRE(named.model.groups.size() == 2);
  CHECK(named.model.groups[0].regions == std::vector<std::int32_t>{1, 3});
  REQUIRE(named.model.attributes.size() == 2);
  CHECK(named.model.attributes[0].name == "density");
  CHECK(std::isnan(named.model.attributes[0].by_region[0]));
  CHECK(named.model.attributes[0].by_region[2] == 2500);
  CHECK((named.model.attributes[1].by_region[0] == 0.3 && named.model.attributes[1].by_region[2] == 0.2));
}

TEST_CASE("regions below min_volume are reported, or join the neighbour across most area", "[sets]") {
  const GridModel grid =
      make_grid_model({4, 4, 3}, {1, 1, 1},
                      {plane("upper", SurfaceKind::horizon, 2, 2), plane("lower", SurfaceKind::horizon, 2, 1),
                       plane("f", SurfaceKind::fault, 0, 1, [](int, int, int k) { return k >= 1 && k <= 2; })});
  NamingRules rules = three_layer_rules();
  rules.min_volume = 5;
  const Named reported = name_grid(grid, rules);
  CHECK(region_names(reported.model) == Names{"top", "middle__1", "middle__2", "bottom"});
  CHECK(some_warning_has(reported.warnings, {"volume of 4", "less than min_volume"}));
  rules.merge_small = true;
  const Named merged = name_grid(grid, rules);
  REQUIRE(merged.model.regions.size() == 3);
  // 4 x 1 against each of top and bottom, 4 x 1 against the other half: the first of the largest is top (its rank is by
  // volume).
  double volume = 0;
  for (const Region& r : merged.model.regions) volume += r.volume;
  CHECK(volume == 48);
  CHECK(some_warning_has(merged.warnings, {"it joins"}));
}

TEST_CASE("what lies above the topography is left out", "[sets]") {
  NamingRules rules{{"soil", "base", "rock"}, {}, {}};
  rules.topography = "relief";
  const GridModel grid = make_grid_model(
      {2, 2, 3}, {1, 1, 1}, {plane("relief", SurfaceKind::horizon, 2, 2), plane("base", SurfaceKind::horizon, 2, 1)});
  const Named named = name_grid(grid, rules);
  CHECK(region_names(named.model) == Names{"soil", "rock"});
  CHECK(named.model.points.size() == 27);
  for (const auto& face : named.model.faces)
    if (face.surface == named.model.surfaces[0].id) CHECK((face.region_minus == 1 && face.region_plus == 0));
  rules.topography = "nowhere";
  CHECK_THROWS_AS(name_grid(grid, rules), Error);
}
