// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces between sticks: whatever the order and the direction in which the sticks come.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <set>
#include <tuple>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/sticks.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

/// Sticks down a listric fault, each with its own number of points.
std::vector<Polyline> listric(std::size_t n) {
  std::vector<Polyline> sticks;
  for (std::size_t k = 0; k < n; ++k) {
    Polyline line{"F1__" + std::to_string(k + 1), "f.pl", {}};
    const std::size_t n_points = 4 + k % 3;
    for (std::size_t i = 0; i < n_points; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(n_points - 1);
      line.points.push_back({1000 + 900 * t * t + 80 * std::sin(0.7 * static_cast<double>(k)),
                             500.0 * static_cast<double>(k), -2000 * t});
    }
    sticks.push_back(std::move(line));
  }
  return sticks;
}

using Corner = std::tuple<double, double, double>;

/// The triangles as sets of places, with neither order nor orientation.
std::set<std::set<Corner>> places(const TriangulatedSurface& s) {
  std::set<std::set<Corner>> all;
  for (const Triangle& t : s.triangles) {
    std::set<Corner> corners;
    for (const VertexIndex v : t) corners.insert({s.points[v].x, s.points[v].y, s.points[v].z});
    all.insert(corners);
  }
  return all;
}

}  // namespace

TEST_CASE("neighbouring sticks are joined by one sheet through all their points", "[gridding][sticks]") {
  const auto sticks = listric(9);
  const SurfaceOfSticks made = surface_of_sticks(sticks, 0);
  std::size_t n_points = 0;
  for (const Polyline& s : sticks) n_points += s.points.size();
  CHECK(made.n_sticks == 9);
  CHECK(made.n_folded == 0);
  CHECK(made.surface.points.size() == n_points);
  // A strip between sticks of p and q points has p + q - 2 triangles; the sticks inside belong to two strips.
  CHECK(made.surface.triangles.size() ==
        2 * n_points - sticks.front().points.size() - sticks.back().points.size() - 16);
}

TEST_CASE("order and direction of the sticks do not matter", "[gridding][sticks]") {
  auto sticks = listric(12);
  const auto wanted = places(surface_of_sticks(sticks, 0).surface);
  std::mt19937 dice(3);
  for (int round = 0; round < 20; ++round) {
    std::shuffle(sticks.begin(), sticks.end(), dice);
    for (Polyline& s : sticks)
      if (dice() % 2) std::reverse(s.points.begin(), s.points.end());
    CHECK(places(surface_of_sticks(sticks, 0).surface) == wanted);
  }
}

TEST_CASE("wide gaps stay open, sticks that cross are told, one stick is refused", "[gridding][sticks]") {
  auto sticks = listric(6);
  sticks.erase(sticks.begin() + 3);
  CHECK(surface_of_sticks(sticks, 700).n_gaps == 1);
  CHECK(surface_of_sticks(sticks, 0).n_gaps == 0);
  sticks = listric(6);
  std::swap(sticks[2].points.back(), sticks[3].points.back());
  const SurfaceOfSticks crossed = surface_of_sticks(sticks, 0);
  CHECK(crossed.n_folded > 0);
  CHECK_THROWS_AS(surface_of_sticks(listric(1), 0), Error);
  CHECK_THROWS_AS(surface_of_sticks({}, 0), Error);
  CHECK(name_without_part("F1__12") == "F1");
  CHECK(name_without_part("F1__a") == "F1__a");
  CHECK(name_without_part("__3") == "__3");
}
