// SPDX-License-Identifier: GPL-3.0-or-later
// How deep surfaces pass through each other: what reaches a depth on both sides passes, what turns back, ends or grazes
// does not.
#include <catch2/catch.hpp>

#include "check/within/passage.hpp"

using geomesh::Index;
using geomesh::Vec3;
using geomesh::geomodel::TriangulatedSurface;
using namespace geomesh::geomodel::checking;

namespace {

/// A sheet over z at x = 0 ... n, each given by its height, from y = -5 to 5.
TriangulatedSurface sheet(const std::vector<double>& heights) {
  TriangulatedSurface s;
  for (std::size_t i = 0; i < heights.size(); ++i)
    for (const double y : {-5.0, 5.0}) s.points.push_back({double(i), y, heights[i]});
  for (Index i = 0; i + 1 < heights.size(); ++i) {
    s.triangles.push_back({2 * i, 2 * i + 2, 2 * i + 3});
    s.triangles.push_back({2 * i, 2 * i + 3, 2 * i + 1});
  }
  return s;
}

/// At the first place along y = 0.3 at which the sheet passes through z = 0: whether it passes deeper than that.
struct Asked {
  double depth;
  double ends_beyond = 1e9;  ///< in x
  std::size_t* n_looked_at = nullptr;
};
bool passes(const std::vector<double>& heights, const Asked& asked) {
  const FollowedSurface surface(sheet(heights));
  TriangulatedSurface level;
  level.points = {{-20, -20, 0}, {40, -20, 0}, {40, 20, 0}, {-20, 20, 0}};
  level.triangles = {{0, 1, 2}, {2, 3, 0}};
  const FollowedSurface other(level);
  for (Index t = 0; t < surface.triangles().size(); ++t)
    for (const Corners& u : other.triangles())
      if (const auto crossing = crossing_of(surface.triangles()[t], u)) {
        const auto& [from, to] = *crossing;
        const Vec3 place = from + 0.47 * (to - from);
        const AlongLine along{[&](const Vec3& p) { return p.x > asked.ends_beyond; },
                              [&](const Vec3&) {
                                if (asked.n_looked_at) ++*asked.n_looked_at;
                              }};
        return passes_through(surface, t, {place, to - from}, other, asked.depth, along);
      }
  FAIL("they do not cross");
  return false;
}

}  // namespace

TEST_CASE("a surface passes through another where it gets deeper on both sides", "[check][passage]") {
  CHECK(passes({-2, -1, 1, 2}, {0.9}));
  CHECK(passes({-2, -1, 1, 2}, {1.9}));
  CHECK_FALSE(passes({-2, -1, 1, 2}, {2.1}));
}

TEST_CASE("a surface that ends or turns back above a depth does not pass", "[check][passage]") {
  CHECK_FALSE(passes({-3, -1, 0.4}, {0.5}));
  CHECK(passes({-3, -1, 0.6}, {0.5}));
  CHECK_FALSE(passes({-3, 0.4, -3}, {0.5}));
  CHECK(passes({-3, 0.6, -3}, {0.5}));
  CHECK_FALSE(passes({-3, 0.4, -0.4, 0.4, -3}, {0.5}));  // passes four times, and comes back
  CHECK(passes({-3, 0.4, -0.4, 3}, {0.5}));
  CHECK_FALSE(passes({-3, -1, 1, 3}, {0.9, 1.7}));  // what is beyond is taken away
}

TEST_CASE("a surface nearly parallel to another is followed as far as it takes", "[check][passage]") {
  std::size_t n = 0;
  CHECK(passes({-0.3, -0.2, -0.1, 0.1, 0.2, 0.3}, {0.25, 1e9, &n}));
  CHECK(n > 50);
  CHECK_FALSE(passes({-0.3, -0.2, -0.1, 0.1, 0.2, 0.3}, {0.35}));
}
