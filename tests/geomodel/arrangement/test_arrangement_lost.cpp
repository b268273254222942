// SPDX-License-Identifier: GPL-3.0-or-later
// What surfaces lose with facets that vanish.
#include <catch2/catch.hpp>

#include "arrangement/join/lost_parts.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using arrangement::lost_with;
using arrangement::VanishedFacet;

namespace {

/// Surface 0 is the square from zero to (100, 100, 0); surface 1 shares the half of it below the diagonal.
arrangement::Complex square() {
  arrangement::Complex c;
  c.points = {{0, 0, 0}, {100, 0, 0}, {100, 100, 0}, {0, 100, 0}};
  c.facets = {{0, 1, 2}, {0, 2, 3}};
  const arrangement::Origin both[] = {{0, 0, false}, {1, 0, false}};
  c.origins.push({both, 2});
  c.origins.push({both, 1});
  return c;
}

constexpr double distance = 10;

}  // namespace

TEST_CASE("lost parts: a facet that vanished inside its surface took nothing with it", "[arrangement]") {
  const std::vector<VanishedFacet> inside{{{0}, {Vec3{50, 50, 0}, Vec3{50, 50, 0}, Vec3{70, 20, 0}}},
                                          {{0}, {Vec3{50, 50, 0}, Vec3{50, 50, 0}, Vec3{70, 20, 1e-3}}}};
  CHECK(lost_with(inside, square(), distance).largest == 0);
  CHECK(lost_with({}, square(), distance).largest == 0);
}

TEST_CASE("lost parts: a strip at which its surface ended is as long as what was lost", "[arrangement]") {
  const std::vector<VanishedFacet> strip{{{0}, {Vec3{100, 50, 0}, Vec3{100, 50, 0}, Vec3{250, 50, 0}}}};
  const Displacement lost = lost_with(strip, square(), distance);
  CHECK(lost.largest == Approx(150));
  CHECK(lost.where == Vec3{250, 50, 0});
}

TEST_CASE("lost parts: what another surface keeps counts for the one that lost it", "[arrangement]") {
  const std::vector<VanishedFacet> on_the_other{{{0, 1}, {Vec3{0, 100, 0}, Vec3{0, 100, 0}, Vec3{10, 90, 0}}}};
  CHECK(lost_with(on_the_other, square(), distance).largest == Approx(std::sqrt(5000.0)));
}

TEST_CASE("lost parts: a long edge is looked at between its ends", "[arrangement]") {
  arrangement::Complex gap = square();
  gap.points.insert(gap.points.end(), {{300, 0, 0}, {400, 0, 0}, {400, 100, 0}});
  gap.facets.push_back({4, 5, 6});
  const arrangement::Origin first{0, 1, false};
  gap.origins.push({&first, 1});
  const std::vector<VanishedFacet> bridge{{{0}, {Vec3{100, 0, 0}, Vec3{300, 0, 0}, Vec3{300, 0, 0}}}};
  CHECK(lost_with(bridge, gap, distance).largest == Approx(100));
}

TEST_CASE("lost parts: of a surface of which nothing is left the extent is lost", "[arrangement]") {
  const std::vector<VanishedFacet> all{{{2}, {Vec3{0, 0, 50}, Vec3{0, 0, 50}, Vec3{3, 4, 50}}}};
  CHECK(lost_with(all, square(), distance).largest == Approx(5));
}
