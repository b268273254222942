// SPDX-License-Identifier: GPL-3.0-or-later
// Facets as thin as rounding.
#include <catch2/catch.hpp>

#include "arrangement/join/flatten_slivers.hpp"
#include "dice.hpp"
#include "require_sound.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;

namespace {

constexpr double ulp = 4.547473508864641e-13;  // of 2000 to 4096

double least_height(const std::vector<Vec3>& points, const Triangle& t) {
  const Vec3 &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
  const double longest = std::max({arrangement::length(b - a), arrangement::length(c - b), arrangement::length(a - c)});
  return 2 * arrangement::area(a, b, c) / longest;
}

/// A square from (1000, 2000, 500) on, with a point on its diagonal but for `off`.
arrangement::Complex square_with_a_point(const Vec3& off) {
  arrangement::Complex c;
  c.points = {{1000, 2000, 500}, {1100, 2000, 500}, {1100, 2100, 500}, {1000, 2100, 500}, Vec3{1037, 2037, 500} + off};
  c.facets = {{0, 1, 4}, {4, 1, 2}, {0, 4, 2}, {0, 2, 3}};
  for (Index f = 0; f < c.facets.size(); ++f) {
    const arrangement::Origin origin{0, f, false};
    c.origins.push({&origin, 1});
  }
  c.input_point.assign(c.points.size(), no_index);
  c.dirty_facet.assign(c.facets.size(), 0);
  return c;
}

}  // namespace

TEST_CASE("slivers: a point beside an edge by rounding comes to lie on it, one farther off stays", "[arrangement]") {
  const double off = GENERATE(2.0, 20.0, 2000.0);  // units in the last place
  arrangement::Complex square = square_with_a_point({0, -off * ulp, 0});
  REQUIRE(least_height(square.points, square.facets[2]) < 0.8 * off * ulp);
  const auto outcome = arrangement::flatten_slivers(square, {32 * ulp, {}, 1, false}, {}, arrangement::no_memory_bound);
  const bool is_thin = off < 32;
  CHECK(outcome.changed() == is_thin);
  CHECK(square.facets.size() == 4);
  double least = 1e300, sum = 0;
  for (const Triangle& t : square.facets) {
    least = std::min(least, least_height(square.points, t));
    sum += arrangement::area(square.points[t[0]], square.points[t[1]], square.points[t[2]]);
  }
  CHECK((least > 1) == is_thin);
  CHECK(sum == Approx(10000));
}

TEST_CASE("slivers: finer doubles next to zero keep no intersections apart", "[arrangement]") {
  // Found by seed 983864 of the random models (--light): the diagonal of a fault's cell passes an edge of the box at
  // zero by less than an ulp of the model's coordinates.
  for (unsigned seed = 0; seed < 200; ++seed) {
    INFO("seed " << seed);
    Dice dice(seed);
    const double x = dice.between(1000, 2000), y = dice.between(3000, 8000), z = dice.between(1000, 4000);
    const double before = dice.between(0.05, 0.2), beyond = dice.between(0.1, 0.9);
    TriangulatedSurface fault{"f", SurfaceKind::fault, {}, {}};
    for (const double k : {-before, beyond})
      for (const double j : {-before, beyond}) fault.points.push_back({x, j * y, k * z});
    fault.triangles = {{0, 1, 3}, {0, 3, 2}};
    ArrangementOptions options;
    options.box = Box3{{0, 0, 0}, {3000, y, z}};
    const PolygonSoup soup = arrange({fault}, {}, {}, options).soup;
    require_sound(soup);
    for (const Vec3& p : soup.points) REQUIRE((p.z == 0 || p.z > 1));
  }
}
