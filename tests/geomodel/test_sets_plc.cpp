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
  const ModelPlc model = make_plc(grid.soup, grid.surfaces, {});
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

TEST_CASE("free edges are borders, of faults tips; two sheets of one surface that cross meet in a curve of its own", "[sets]") {
  const auto inner = [](int i, int, int) { return i <= 2; };
  const GridModel grid = make_grid_model({4, 2, 4}, {1, 1, 1},
                                         {plane("h", SurfaceKind::horizon, 2, 1, inner),
                                          plane("f", SurfaceKind::fault, 0, 3, [](int, int, int k) { return k >= 2; }),
                                          {"x", SurfaceKind::surface, [](const auto& v) {
                                             return std::all_of(v.begin(), v.end(), [](const auto& g) { return g[0] == 1; }) ||
                                                    std::all_of(v.begin(), v.end(), [](const auto& g) { return g[2] == 3 && g[0] <= 2; });
                                           }}});
  const ModelPlc model = make_plc(grid.soup, grid.surfaces, {});
  CHECK(curve_names(model, "border") == std::set<std::string>{"h.border", "x.border"});
  CHECK(curve_names(model, "fault_tip") == std::set<std::string>{"f.tip"});
  CHECK(n_segments_of(model, "h.border") == 2);
  CHECK(n_segments_of(model, "f.tip") == 2);
  CHECK(n_segments_of(model, "x*x") == 2);
  CHECK(n_segments_of(model, "h*x") == 2);
}

TEST_CASE("surfaces that coincide make one facet with a set of two, and a well keeps its own curve on shared segments", "[sets]") {
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
