// SPDX-License-Identifier: GPL-3.0-or-later
// Patches of one fault that are nearer to each other than the tolerance.
#include <catch2/catch.hpp>
#include <map>

#include "arrangement_inputs.hpp"
#include "require_sound.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;

namespace {

ArrangementOptions where_surfaces_meet_within(double tolerance) {
  ArrangementOptions options;
  options.tolerance = tolerance;
  options.merging = ArrangementOptions::MergingOf::surfaces_that_meet;
  return options;
}

/// Edges of one facet alone.
std::size_t n_border_edges(const PolygonSoup& soup) {
  std::map<std::pair<VertexIndex, VertexIndex>, std::size_t> n_at;
  for (const Triangle& t : soup.facets)
    for (std::size_t k = 0; k < 3; ++k) ++n_at[std::minmax(t[k], t[(k + 1) % 3])];
  return static_cast<std::size_t>(
      std::count_if(n_at.begin(), n_at.end(), [](const auto& at) { return at.second == 1; }));
}

TriangulatedSurface both(TriangulatedSurface a, const TriangulatedSurface& b) {
  const auto first = static_cast<VertexIndex>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return a;
}

}  // namespace

TEST_CASE("patches of a fault: a patch of triangles smaller than the tolerance does not fold", "[arrangement]") {
  const double spacing = 0.004;
  const auto ridges = [](double x, double y) { return 0.003 * std::sin(700 * x) * std::cos(500 * y); };
  const auto fine = grid_surface("fine", SurfaceKind::fault, 10, 0, 10 * spacing, 0, 10 * spacing, ridges);
  const auto far = grid_surface("fine", SurfaceKind::fault, 3, 1, 2, 1, 2, [](double, double) { return 0; });
  const auto result = arrange({both(fine, far)}, {}, {}, where_surfaces_meet_within(0.01));
  require_sound(result.soup);
  CHECK(result.soup.facets.size() == 200 + 18);
  CHECK(n_border_edges(result.soup) == 40 + 12);
  CHECK(result.merging.vertices_merged + result.merging.vertices_inserted == 0);
}

TEST_CASE("patches of a fault: patches that lie on each other along their seam become one sheet", "[arrangement]") {
  const auto flat = [](double, double) { return 0; };
  const auto west = grid_surface("fault", SurfaceKind::fault, 4, 0, 4, 0, 4, flat);
  const auto east =
      grid_surface("fault", SurfaceKind::fault, 4, 4.004, 8, 0, 4, [](double x, double) { return 0.001 * x; });
  const auto apart = arrange({both(west, east)}, {}, {}, {});
  CHECK(n_border_edges(apart.soup) == 32);
  const auto result = arrange({both(west, east)}, {}, {}, where_surfaces_meet_within(0.01));
  require_sound(result.soup);
  CHECK(result.soup.facets.size() == 64);
  CHECK(n_border_edges(result.soup) == 24);
  CHECK(result.merging.vertices_merged == 5);
}

TEST_CASE("patches of a fault: a patch that ends beside the middle of another ends on it", "[arrangement]") {
  const auto wide = grid_surface("fault", SurfaceKind::fault, 4, 0, 8, 0, 8, [](double, double) { return 0; });
  const auto branch = triangles("fault", {{Vec3{3, 3, 0.006}, Vec3{5, 4, 0.004}, Vec3{5, 4, 3}},
                                          {Vec3{3, 3, 0.006}, Vec3{5, 4, 3}, Vec3{3, 3, 3}}});
  const auto fault = both(wide, branch);
  const std::size_t n_free = n_border_edges(arrange({fault}, {}, {}, {}).soup);
  const auto result = arrange({fault}, {}, {}, where_surfaces_meet_within(0.01));
  require_sound(result.soup);
  CHECK(n_free == 32 / 2 + 4);
  CHECK(n_border_edges(result.soup) == n_free - 1);
}
