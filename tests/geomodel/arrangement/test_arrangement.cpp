// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "arrangement_inputs.hpp"
#include "require_sound.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;

TEST_CASE("arrange: a salt dome cuts horizons and the box clips them", "[arrangement]") {
  std::vector<TriangulatedSurface> surfaces;
  for (int h = 0; h < 3; ++h)
    surfaces.push_back(grid_surface(
        "horizon_" + std::to_string(h), SurfaceKind::horizon, 20, -100, 10100, -90, 8090,
        [h](double x, double y) { return -1000.0 - 900 * h + 150 * std::sin(x / 900) * std::cos(y / 1100); }));
  surfaces.push_back(ellipsoid("salt", {5000.3, 4000.7, -2500}, {1500, 1200, 1900}, 3));
  surfaces.back().cuts_all = true;
  ArrangementOptions options;
  options.box = Box3{{0, 0, -5000}, {10000, 8000, 0}};
  const ArrangementResult result = arrange(surfaces, {}, {}, options);
  require_sound(result.soup);
  const PolygonSoup& soup = result.soup;
  REQUIRE(result.box_sides.size() == 6);
  for (const Vec3& p : soup.points)
    for (std::size_t i = 0; i < 3; ++i) REQUIRE((p[i] >= options.box->min[i] && p[i] <= options.box->max[i]));
  for (Index f = 0; f < soup.facets.size(); ++f) {
    const Index surface = soup.origins[soup.origin_offsets[f]].surface;
    const auto& [a, b, c] = soup.facets[f];
    if (surface >= 4) {
      const std::size_t axis = (surface - 4) / 2;
      const double plane = (surface - 4) % 2 == 0 ? options.box->min[axis] : options.box->max[axis];
      REQUIRE((soup.points[a][axis] == plane && soup.points[b][axis] == plane && soup.points[c][axis] == plane));
    } else if (surface < 3) {
      const Vec3 middle = (1.0 / 3) * (soup.points[a] + soup.points[b] + soup.points[c]);
      REQUIRE(winding_number(surfaces[3], middle) == 0);
    }
  }
  for (Index h = 0; h < 3; ++h) {
    CHECK(result.area_clipped_by_bodies[h] > 1e5);
    CHECK(result.area_clipped_by_box[h] > 1e5);
    CHECK(area_of(soup, h) + result.area_clipped_by_bodies[h] + result.area_clipped_by_box[h] ==
          Approx(area_of(surfaces[h])).epsilon(1e-12));
  }
  CHECK(area_of(soup, 3) == Approx(area_of(surfaces[3])).epsilon(1e-12));
  CHECK(volume_inside(soup, [](const auto& o) { return o.surface >= 4; }) ==
        Approx(10000.0 * 8000 * 5000).epsilon(1e-12));
}

TEST_CASE("arrange: random soups on an integer grid", "[arrangement]") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const RandomSoup soup = random_soup(seed);
    INFO("seed " << seed);
    require_sound(arrange(soup.surfaces, soup.polylines, soup.points, soup.options).soup);
  }
}

TEST_CASE("arrange: 2000 random soups on an integer grid", "[arrangement][nightly]") {
  for (unsigned seed = 0; seed < 2000; ++seed) {
    const RandomSoup soup = random_soup(seed);
    INFO("seed " << seed);
    require_sound(arrange(soup.surfaces, soup.polylines, soup.points, soup.options).soup);
  }
}
