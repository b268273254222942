// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <set>

#include "grid_model.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;

namespace {

std::set<std::string> curve_names(const ModelPlc& model, const std::string& kind) {
  std::set<std::string> names;
  for (const SoupCurve& c : model.curves)
    if (c.kind == kind) names.insert(c.name);
  return names;
}

std::size_t n_segments_of(const ModelPlc& model, const std::string& name) {
  std::size_t n = 0;
  for (const auto& rows : model.segment_curves)
    for (Index row : rows) n += model.curves[row].name == name;
  return n;
}

}  // namespace

TEST_CASE("a layered box becomes a PLC with patches and curves named by the surfaces that meet", "[sets]") {
  const GridModel grid = three_layers(2);
  const ModelPlc model = make_plc(grid.soup, grid.surfaces, {}, {false});
  CHECK(model.plc.n_facets() == grid.soup.facets.size());
  CHECK(model.plc.points == grid.soup.points);
  // 12 edges of the box; four edges of each horizon on the sides.
  const auto names = curve_names(model, "intersection");
  CHECK(names.size() == 12 + 8);
  CHECK(names.contains("upper*xmin"));
  CHECK(names.contains("xmin*ymin"));
  CHECK(curve_names(model, "border").empty());
  CHECK(n_segments_of(model, "upper*xmin") == 2);
  CHECK(n_segments_of(model, "xmin*ymin") == 3);
  // Patches: two horizons, zmin, zmax, and four sides cut into three.
  CHECK(*std::max_element(model.facet_patch.begin(), model.facet_patch.end()) == 2 + 2 + 4 * 3);
  CHECK(model.facet_patch.front() == 1);
}

TEST_CASE("free edges are borders, of faults tips; two sheets of one surface that cross meet in a curve of its own",
          "[sets]") {
  const auto inner = [](int i, int, int) { return i <= 2; };
  const GridModel grid =
      make_grid_model({4, 2, 4}, {1, 1, 1},
                      {plane("h", SurfaceKind::horizon, 2, 1, inner),
                       plane("f", SurfaceKind::fault, 0, 3, [](int, int, int k) { return k >= 2; }),
                       {"x", SurfaceKind::surface, [](const auto& v) {
                          return std::all_of(v.begin(), v.end(), [](const auto& g) { return g[0] == 1; }) ||
                                 std::all_of(v.begin(), v.end(), [](const auto& g) { return g[2] == 3 && g[0] <= 2; });
                        }}});
  const ModelPlc model = make_plc(grid.soup, grid.surfaces, {}, {false});
  CHECK(curve_names(model, "border") == std::set<std::string>{"h.border", "x.border"});
  CHECK(curve_names(model, "fault_tip") == std::set<std::string>{"f.tip"});
  CHECK(n_segments_of(model, "h.border") == 2);
  CHECK(n_segments_of(model, "f.tip") == 2);
  CHECK(n_segments_of(model, "x*x") == 2);
  CHECK(n_segments_of(model, "h*x") == 2);
}

TEST_CASE("surfaces that coincide make one facet with a set of two, and a well keeps its own curve on shared segments",
          "[sets]") {
  GridModel grid = make_grid_model({2, 1, 2}, {1, 1, 1},
                                   {plane("a", SurfaceKind::horizon, 2, 1),
                                    plane("b", SurfaceKind::horizon, 2, 1, [](int i, int, int) { return i <= 1; })});
  grid.soup.segments.push_back({grid.soup.facets[0][0], grid.soup.facets[0][1], 0});
  const VertexIndex p = static_cast<VertexIndex>(grid.soup.points.size());
  grid.soup.points.push_back({0.25, 0.5, 0.5});
  grid.soup.isolated_points = {{p, 0}, {grid.soup.facets[0][0], 1}};
  const ModelPlc model = make_plc(grid.soup, grid.surfaces, {Polyline{"W1", "", {}}});
  CHECK(std::count(model.plc.provenance_sets.begin(), model.plc.provenance_sets.end(), std::vector<Index>{0, 1}) == 1);
  CHECK(n_segments_of(model, "a*b") == 1);  // where b ends on a
  CHECK(n_segments_of(model, "W1") == 1);
  CHECK(model.curves.back().kind == "well");
  CHECK(model.plc.isolated_points == std::vector<VertexIndex>{p});
}

TEST_CASE("patches on box sides become polygons with holes, inner segments and inner points", "[sets]") {
  // A fault that touches zmin along a line inside it, a pipe through zmin that leaves a hole, and nothing else.
  GridModel grid = make_grid_model(
      {5, 3, 2}, {1, 1, 1},
      {plane("f", SurfaceKind::fault, 0, 4, [](int, int j, int k) { return j >= 1 && j <= 2 && k <= 1; }),
       {"pipe", SurfaceKind::surface, [](const auto& v) {
          const auto all = [&](auto holds) { return std::all_of(v.begin(), v.end(), holds); };
          return all([](const auto& g) { return g[1] >= 1 && g[1] <= 2 && (g[0] == 1); }) ||
                 all([](const auto& g) { return g[1] >= 1 && g[1] <= 2 && (g[0] == 2); }) ||
                 all([](const auto& g) { return g[0] >= 1 && g[0] <= 2 && (g[1] == 1); }) ||
                 all([](const auto& g) { return g[0] >= 1 && g[0] <= 2 && (g[1] == 2); });
        }}});
  const ModelPlc model = make_plc(grid.soup, grid.surfaces, {});
  std::size_t n_polygons = 0, n_with_hole = 0, n_soup = 0;
  for (Index f = 0; f < model.plc.n_facets(); ++f) {
    const std::size_t n = model.facet_soup_offsets[f + 1] - model.facet_soup_offsets[f];
    n_soup += n;
    if (n == 1) continue;
    ++n_polygons;
    if (model.plc.n_loops(f) == 1) continue;
    ++n_with_hole;
    CHECK(model.plc.outer_loop(f).size() == 16);
    CHECK(model.plc.loop(model.plc.facet_loops[f] + 1).size() == 4);
  }
  CHECK(n_soup == grid.soup.facets.size());
  CHECK(n_polygons == 8);  // zmin and zmax each cut by the pipe into two, four other sides
  CHECK(n_with_hole == 2);
  CHECK(model.plc.facet_segments.size() == 1);
  // Inner grid points of the sides: zmin has 8, 4 on the hole, 2 on the segment; zmax has 4 left; the others 2 or 4
  // each.
  std::size_t on_zmin = 0;
  for (const auto& p : model.plc.facet_points) on_zmin += model.plc.points[p.v].z == 0;
  CHECK(on_zmin == 2);
}
