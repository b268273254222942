// SPDX-License-Identifier: GPL-3.0-or-later
// Patches of one fault that are nearer to each other than the tolerance.
#include <catch2/catch.hpp>
#include <map>
#include <random>

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

std::map<std::pair<VertexIndex, VertexIndex>, std::size_t> facets_at_edges(const PolygonSoup& soup) {
  std::map<std::pair<VertexIndex, VertexIndex>, std::size_t> n_at;
  for (const Triangle& t : soup.facets)
    for (std::size_t k = 0; k < 3; ++k) ++n_at[std::minmax(t[k], t[(k + 1) % 3])];
  return n_at;
}

/// Edges of one facet alone.
std::size_t n_border_edges(const PolygonSoup& soup) {
  const auto n_at = facets_at_edges(soup);
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

TEST_CASE("patches of a fault: a rough sheet of triangles smaller than the tolerance gets no holes", "[arrangement]") {
  const double tolerance = 0.01, spacing = 0.6 * tolerance, width = 12 * spacing;
  for (unsigned seed = 0; seed < 40; ++seed) {
    INFO("seed " << seed);
    std::mt19937 dice(seed);
    std::uniform_real_distribution<double> height(-1.2 * tolerance, 1.2 * tolerance);
    auto rough = grid_surface("rough", SurfaceKind::fault, 12, 0, width, 0, width, [](double, double) { return 0; });
    for (Vec3& p : rough.points) p.z = height(dice);
    const auto result = arrange({rough}, {}, {}, where_surfaces_meet_within(tolerance));
    require_sound(result.soup);
    for (const auto& [edge, n] : facets_at_edges(result.soup)) {
      if (n != 1) continue;
      const Vec3 p = 0.5 * (result.soup.points[edge.first] + result.soup.points[edge.second]);
      CHECK(std::min({p.x, p.y, width - p.x, width - p.y}) < 2 * tolerance);
    }
  }
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
