// SPDX-License-Identifier: GPL-3.0-or-later
// Horizons moved to the tops of wells.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/tops.hpp"
#include "scratch.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

/// A lattice of n by n cells of 100 m with its first node at x.
void add_lattice(TriangulatedSurface& s, double x, std::size_t n, double z) {
  const auto first = static_cast<VertexIndex>(s.points.size()), row = static_cast<VertexIndex>(n + 1);
  for (std::size_t j = 0; j <= n; ++j)
    for (std::size_t i = 0; i <= n; ++i)
      s.points.push_back({x + 100.0 * static_cast<double>(i), 100.0 * static_cast<double>(j), z});
  for (VertexIndex j = 0; j < n; ++j)
    for (VertexIndex i = 0; i < n; ++i) {
      const VertexIndex a = first + j * row + i;
      s.triangles.push_back({a, a + 1, a + row + 1});
      s.triangles.push_back({a, a + row + 1, a + row});
    }
}

FittedTop top_at(const Vec3& place) { return {"w", "h", place}; }

}  // namespace

TEST_CASE("a moved horizon passes through its tops and is as it was beyond their reach", "[tops]") {
  TriangulatedSurface s;
  add_lattice(s, 0, 20, -1000);
  std::vector<FittedTop> tops{top_at({433, 512, -1020}), top_at({655, 540, -985}), top_at({1930, 1910, -1001})};
  fit_to_tops(s, tops, 500);
  CHECK(tops[0].misfit_given == Approx(-20));
  CHECK(tops[1].misfit_given == Approx(15));
  for (const FittedTop& top : tops) CHECK(std::abs(top.misfit_fitted) < 1e-9);
  for (const Vec3& p : s.points) {
    const bool is_beyond = std::hypot(p.x - 433, p.y - 512) > 500 && std::hypot(p.x - 655, p.y - 540) > 500 &&
                           std::hypot(p.x - 1930, p.y - 1910) > 500;
    if (is_beyond) CHECK(p.z == -1000);
  }
}

TEST_CASE("a top moves the sheet that is over or under it, and no other", "[tops]") {
  TriangulatedSurface s;
  add_lattice(s, 0, 10, -1000);
  const std::size_t n_first = s.points.size();
  add_lattice(s, 1000, 10, -1100);
  std::vector<FittedTop> tops{top_at({950, 500, -1010})};
  fit_to_tops(s, tops, 800);
  CHECK(std::abs(tops[0].misfit_fitted) < 1e-9);
  for (std::size_t v = n_first; v < s.points.size(); ++v) CHECK(s.points[v].z == -1100);
}

TEST_CASE("tops over one triangle that contradict each other are met in the mean", "[tops]") {
  TriangulatedSurface s;
  add_lattice(s, 0, 4, 0);
  std::vector<FittedTop> tops{top_at({250, 220, 4}), top_at({250, 220, 8})};
  fit_to_tops(s, tops, 300);
  CHECK(tops[0].misfit_fitted == Approx(-2));
  CHECK(tops[1].misfit_fitted == Approx(2));
}

TEST_CASE("a top beside the horizon moves nothing", "[tops]") {
  TriangulatedSurface s;
  add_lattice(s, 0, 4, 0);
  std::vector<FittedTop> tops{top_at({900, 200, 4})};
  fit_to_tops(s, tops, 0);
  CHECK(std::isnan(tops[0].misfit_given));
  for (const Vec3& p : s.points) CHECK(p.z == 0);
}

TEST_CASE("tables of tops are read by the names of their columns", "[tops]") {
  const std::filesystem::path file = testing::scratch_folder() / "tops.txt";
  for (const std::string text :
       {"# made\nMD;Well;Marker\n1012.5;W 1;top_sand\n", "well\thorizon\tdepth\n\nW 1\ttop_sand\t1012.5\n"}) {
    std::ofstream(file) << text;
    const std::vector<WellTop> tops = read_tops(file);
    REQUIRE(tops.size() == 1);
    CHECK(tops[0].well == "W 1");
    CHECK(tops[0].horizon == "top_sand");
    CHECK(tops[0].depth == 1012.5);
  }
  for (const std::string text :
       {"", "well,horizon\nw,h\n", "well,horizon,depth\nw,h\n", "well,horizon,depth\nw,h,deep\n"}) {
    std::ofstream(file) << text;
    CHECK_THROWS_AS(read_tops(file), Error);
  }
}

TEST_CASE("a place on a path by length and by height", "[tops]") {
  const std::vector<Vec3> path{{0, 0, 0}, {0, 0, -100}, {30, 40, -100}, {30, 40, -300}};
  CHECK(place_on_path(path, 125, false).value() == Vec3{15, 20, -100});
  CHECK(place_on_path(path, -200, true).value() == Vec3{30, 40, -200});
  CHECK_FALSE(place_on_path(path, 400, false));
  CHECK_FALSE(place_on_path(path, 20, true));
}
