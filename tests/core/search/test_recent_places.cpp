// SPDX-License-Identifier: MIT
// What is remembered is what was asked for, also where places share a row.
#include <catch2/catch.hpp>

#include "search/recent_places.hpp"

using namespace geomesh;
using geomesh::search::RecentPlaces;

TEST_CASE("Recent places have the values of their function, computed once for the same place again", "[search]") {
  std::size_t n_asked = 0;
  const auto value_at = [&](const Vec3& p) {
    return [&n_asked, p](const RecentPlaces::Known&) { return ++n_asked, p.x + 10 * p.y; };
  };
  for (const std::size_t n_places : {std::size_t{1}, std::size_t{3}, std::size_t{64}}) {
    RecentPlaces recent(n_places);
    for (int round = 0; round < 2; ++round)
      for (int i = 0; i < 40; ++i) {
        const Vec3 p{1.0 * i, 0.5 * (i % 3), 0};
        CHECK(recent.at(p, value_at(p)) == p.x + 10 * p.y);
        const std::size_t n_before = n_asked;
        CHECK(recent.at(p, value_at(p)) == p.x + 10 * p.y);
        CHECK(n_asked == n_before);
      }
    recent.clear();
    const std::size_t n_before = n_asked;
    CHECK(recent.at({1, 0, 0}, value_at({1, 0, 0})) == 1);
    CHECK(n_asked == n_before + 1);
  }
}
