// SPDX-License-Identifier: GPL-3.0-or-later
// Charts: what the broad phase leaves out must really be free of contacts, and well-behaved surfaces must be left out
// nearly whole.
#include <catch2/catch.hpp>
#include <set>

#include "arrangement/model/contacts.hpp"
#include "arrangement/model/ingest.hpp"
#include "arrangement/search/charts.hpp"
#include "arrangement_inputs.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::arrangement;
using namespace geomesh::geomodel::testing;

namespace {

Complex complex_of(const std::vector<TriangulatedSurface>& surfaces) {
  const std::vector<TriangulatedSurface> no_sides;
  return ingest({surfaces, no_sides}, {}, {}, std::nullopt).complex;
}

/// Every pair of facets of one chart is free of contacts by the narrow phase. Returns the share of facets in charts.
double require_charts_free_of_contacts(const Complex& complex) {
  const std::vector<Index> chart_of = find_charts(complex);
  std::map<Index, std::vector<Index>> facets_of;
  std::size_t n_charted = 0;
  for (Index f = 0; f < chart_of.size(); ++f)
    if (chart_of[f] != no_index) {
      facets_of[chart_of[f]].push_back(f);
      ++n_charted;
    }
  Contacts contacts;
  for (const auto& [chart, facets] : facets_of)
    for (std::size_t a = 0; a < facets.size(); ++a)
      for (std::size_t b = a + 1; b < facets.size(); ++b) facet_facet_contact(complex, facets[a], facets[b], contacts);
  CHECK(contacts.empty());
  return static_cast<double>(n_charted) / static_cast<double>(complex.facets.size());
}

/// A ramp that winds about the z axis, `turns` times.
TriangulatedSurface spiral_ramp(double turns) {
  TriangulatedSurface s = grid_surface("ramp", SurfaceKind::surface, 40, 0, 1, 0, 1, [](double, double) { return 0; });
  for (Vec3& p : s.points) {
    const double angle = 6.283185307179586 * turns * p.x, r = 1 + p.y;
    p = {r * std::cos(angle), r * std::sin(angle), p.x};
  }
  return s;
}

}  // namespace

TEST_CASE("charts: a height field is one chart", "[arrangement]") {
  const auto grid = grid_surface("grid", SurfaceKind::horizon, 20, 0, 10, 0, 10,
                                 [](double x, double y) { return 0.1 * std::sin(x) * y; });
  const std::vector<Index> chart_of = find_charts(complex_of({grid}));
  CHECK(std::set<Index>(chart_of.begin(), chart_of.end()) == std::set<Index>{0});
}

TEST_CASE("charts: surfaces that wind over themselves", "[arrangement]") {
  CHECK(require_charts_free_of_contacts(complex_of({spiral_ramp(0.9)})) > 0.99);
  for (const double turns : {1.1, 2.0, 2.5}) require_charts_free_of_contacts(complex_of({spiral_ramp(turns)}));
  // Ends that cross: seen along z the ramp overlaps itself and meets itself there.
  TriangulatedSurface crossing = spiral_ramp(1.2);
  for (Vec3& p : crossing.points) p.z = 0.1 * p.x;
  const Complex complex = complex_of({crossing});
  require_charts_free_of_contacts(complex);
  RunContext context;
  CHECK_FALSE(find_contacts(complex, context).empty());
}

TEST_CASE("charts: holes, corners where parts only touch, and facets turned at random", "[arrangement]") {
  for (unsigned seed = 0; seed < 40; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    auto grid = grid_surface("grid", SurfaceKind::horizon, 14, 0, 14, 0, 14,
                             [&](double, double) { return 0.05 * (random() % 20); });
    std::erase_if(grid.triangles, [&](const Triangle&) { return random() % 100 < 2 * (seed % 10); });
    for (Triangle& t : grid.triangles)
      if (random() % 2) std::swap(t[0], t[1]);
    require_charts_free_of_contacts(complex_of({grid}));
  }
}

TEST_CASE("charts: points pushed about, so that facets fold over and cross", "[arrangement]") {
  for (unsigned seed = 0; seed < 40; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    auto grid = grid_surface("grid", SurfaceKind::horizon, 14, 0, 14, 0, 14, [&](double, double) { return 0.0; });
    for (Vec3& p : grid.points) {
      if (random() % 100 >= 5 + seed) continue;
      p.x += static_cast<double>(random() % 5) - 2;
      p.y += static_cast<double>(random() % 5) - 2;
    }
    require_charts_free_of_contacts(complex_of({grid}));
  }
}

TEST_CASE("charts: solids", "[arrangement]") {
  CHECK(require_charts_free_of_contacts(complex_of({ellipsoid("ball", {0, 0, 0}, {1, 2, 3}, 4)})) > 0.9);
}

TEST_CASE("winds_at_most_once: borders", "[arrangement]") {
  // Seen along z. Outer square, inner square, a square beside it, a square that touches the first in a corner.
  const std::vector<Vec3> p{{0, 0, 0}, {4, 0, 1}, {4, 4, 0}, {0, 4, 2}, {1, 1, 0}, {2, 1, 5}, {2, 2, 0}, {1, 2, 0},
                            {6, 0, 0}, {7, 0, 0}, {7, 1, 0}, {6, 1, 0}, {5, 4, 0}, {5, 5, 0}, {4, 5, 0}};
  const auto loop = [](std::vector<BorderEdge>& border, std::vector<VertexIndex> v, bool reversed) {
    if (reversed) std::reverse(v.begin(), v.end());
    for (std::size_t k = 0; k < v.size(); ++k) border.push_back({v[k], v[(k + 1) % v.size()]});
  };
  const auto winds_once = [&](const std::vector<std::pair<std::vector<VertexIndex>, bool>>& loops) {
    std::vector<BorderEdge> border;
    for (const auto& [v, reversed] : loops) loop(border, v, reversed);
    return winds_at_most_once(p, 2, border);
  };
  const std::vector<VertexIndex> outer{0, 1, 2, 3}, inner{4, 5, 6, 7}, beside{8, 9, 10, 11}, touching{2, 12, 13, 14};
  CHECK(winds_once({{outer, false}}));
  CHECK_FALSE(winds_once({{outer, true}}));
  CHECK(winds_once({{outer, false}, {inner, true}}));
  CHECK_FALSE(winds_once({{outer, false}, {inner, false}}));   // winds twice about the inner one
  CHECK_FALSE(winds_once({{outer, false}, {beside, false}}));  // harmless, but not told apart from the one before
  CHECK(winds_once({{outer, false}, {touching, false}}));
  CHECK_FALSE(winds_once({{outer, false}, {touching, true}}));
  CHECK_FALSE(winds_once({{{0, 2, 1, 3}, false}}));  // crosses itself
}
