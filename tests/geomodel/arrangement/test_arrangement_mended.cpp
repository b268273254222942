// SPDX-License-Identifier: GPL-3.0-or-later
// What is left of surfaces where facets vanished: flaps that hang from them, and holes before facets of others.
#include <catch2/catch.hpp>
#include <map>

#include "arrangement/model/surface_ends.hpp"
#include "arrangement/pockets/close_pockets.hpp"
#include "arrangement/pockets/cut_dangling_faces.hpp"
#include "arrangement/pockets/fill_holes.hpp"
#include "arrangement/snap/snap.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::arrangement;

namespace {

struct Part {
  Triangle corners;
  std::vector<Index> surfaces;
};

Complex complex_of(std::vector<Vec3> points, const std::vector<Part>& parts) {
  Complex complex;
  complex.points = std::move(points);
  complex.input_point.assign(complex.points.size(), no_index);
  for (Index f = 0; f < parts.size(); ++f) {
    complex.facets.push_back(parts[f].corners);
    std::vector<Origin> origins;
    for (const Index surface : parts[f].surfaces) origins.push_back({surface, f, false});
    complex.origins.push(origins);
    complex.dirty_facet.push_back(0);
  }
  return complex;
}

/// A tetrahedron, and points at `height` over the middle of its edge (0, 1), outside.
std::vector<Vec3> tetrahedron_and_points_beside(double height) {
  return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.4, -height, -height}, {0.6, -height, -height}};
}
const std::vector<Part> sides{{{0, 2, 1}, {0}}, {{0, 1, 3}, {0}}, {{1, 2, 3}, {0}}, {{0, 3, 2}, {0}}};

std::vector<Part> with(std::vector<Part> parts, const std::vector<Part>& more) {
  parts.insert(parts.end(), more.begin(), more.end());
  return parts;
}

/// Edges where the surface goes on from one facet to the next turned over.
std::size_t n_turned(const Complex& complex, Index surface) {
  std::map<std::array<VertexIndex, 2>, int> balance;
  for (Index f = 0; f < complex.facets.size(); ++f)
    for (const Origin& o : complex.origins.of(f))
      for (std::size_t k = 0; k < 3 && o.surface == surface; ++k) {
        const VertexIndex a = complex.facets[f][k], b = complex.facets[f][(k + 1) % 3];
        balance[{std::min(a, b), std::max(a, b)}] += (a < b) != o.reversed ? 1 : -1;
      }
  std::size_t n = 0;
  for (const auto& [edge, sum] : balance) n += std::abs(sum) > 1;
  return n;
}

}  // namespace

TEST_CASE("dangling faces: what hangs from a closed body and is thinner than the distance goes", "[arrangement]") {
  const std::vector<Part> one{{{0, 1, 4}, {0}}}, two{{{0, 1, 4}, {0}}, {{1, 5, 4}, {0}}};
  for (const std::vector<Part>& flap : {one, two}) {
    Complex complex = complex_of(tetrahedron_and_points_beside(0.01), with(sides, flap));
    CHECK(surface_ends(complex).size() == flap.size() + 1);
    const CutDanglingFaces cut = cut_dangling_faces(complex, 0.02);
    CHECK(cut.n_pieces == 1);
    CHECK(cut.vanished.size() == flap.size());
    CHECK(cut.moved.largest == Approx(0.01 * std::sqrt(2.)));
    CHECK(complex.facets.size() == 4);
    CHECK(complex.dirty_facet.size() == 4);
    CHECK(surface_ends(complex).empty());
  }
}

TEST_CASE("dangling faces: what reaches farther than the distance stays", "[arrangement]") {
  Complex complex = complex_of(tetrahedron_and_points_beside(0.1), with(sides, {{{0, 1, 4}, {0}}}));
  CHECK(cut_dangling_faces(complex, 0.02).n_pieces == 0);
  CHECK(complex.facets.size() == 5);
}

TEST_CASE("dangling faces: a wide sheet between two hinges stays, though all of its corners are on these",
          "[arrangement]") {
  // Two tetrahedra three apart, and a sheet from an edge of the one to an edge of the other.
  std::vector<Vec3> points = tetrahedron_and_points_beside(0.01);
  for (const Vec3& p : {Vec3{0, -3, 0}, Vec3{1, -3, 0}, Vec3{0, -4, 0.5}, Vec3{0, -3.5, 1}}) points.push_back(p);
  const std::vector<Part> other{{{6, 8, 7}, {0}}, {{6, 7, 9}, {0}}, {{7, 8, 9}, {0}}, {{6, 9, 8}, {0}}},
      sheet{{{0, 1, 7}, {0}}, {{0, 7, 6}, {0}}};
  Complex complex = complex_of(points, with(with(sides, other), sheet));
  REQUIRE(surface_ends(complex).size() == 2);
  CHECK(cut_dangling_faces(complex, 0.02).n_pieces == 0);
  CHECK(complex.facets.size() == 10);
}

TEST_CASE("dangling faces: the end of a surface is none, however thin", "[arrangement]") {
  Complex open = complex_of(tetrahedron_and_points_beside(0.01), {{{0, 2, 1}, {0}}, {{0, 1, 4}, {0}}});
  CHECK(cut_dangling_faces(open, 0.02).n_pieces == 0);
  CHECK(open.facets.size() == 2);
}

TEST_CASE("dangling faces: of two that share a hinge the surface keeps what makes it whole", "[arrangement]") {
  // Three strips that meet at one edge: without any two of them the surface would end there.
  Complex strips = complex_of({{0, 0, 0}, {1, 0, 0}, {0.5, 0.01, 0}, {0.5, -0.01, 0}, {0.5, 0, 0.01}},
                              {{{0, 1, 2}, {0}}, {{0, 1, 3}, {0}}, {{0, 1, 4}, {0}}});
  CHECK(cut_dangling_faces(strips, 0.02).n_pieces == 1);
  CHECK(strips.facets.size() == 2);
}

TEST_CASE("dangling faces: one on which another surface ends becomes that one's", "[arrangement]") {
  // Surface 1 comes from far below and ends on the flap's edge (1, 4), or on one facet of two.
  std::vector<Vec3> points = tetrahedron_and_points_beside(0.01);
  points.push_back({0.7, -3, -3});
  const std::vector<Part> one{{{0, 1, 4}, {0}}, {{1, 6, 4}, {1}}},
      two{{{0, 1, 4}, {0}}, {{1, 5, 4}, {0}}, {{1, 6, 5}, {1}}};
  for (const std::vector<Part>& more : {one, two}) {
    Complex complex = complex_of(points, with(sides, more));
    CHECK(cut_dangling_faces(complex, 0.02).n_pieces == 1);
    REQUIRE(complex.facets.size() == sides.size() + more.size());
    for (std::size_t f = sides.size(); f < complex.facets.size(); ++f) {
      REQUIRE(complex.origins.of(f).size() == 1);
      CHECK(complex.origins.of(f)[0].surface == 1);
    }
    CHECK(n_turned(complex, 0) == 0);
    CHECK(n_turned(complex, 1) == 0);
  }
}

TEST_CASE("dangling faces: one that another surface crosses, or on which two end, stays", "[arrangement]") {
  std::vector<Vec3> points = tetrahedron_and_points_beside(0.01);
  points.push_back({0.7, -3, -3});
  points.push_back({0.2, -3, -3});
  const Part flap{{0, 1, 4}, {0}};
  for (const std::vector<Part>& more : {std::vector<Part>{flap, {{1, 6, 4}, {1}}, {{1, 4, 7}, {1}}},
                                        std::vector<Part>{flap, {{1, 6, 4}, {1}}, {{0, 4, 7}, {2}}}}) {
    Complex complex = complex_of(points, with(sides, more));
    CHECK(cut_dangling_faces(complex, 0.02).n_pieces == 0);
    CHECK(complex.origins.of(4)[0].surface == 0);
  }
}

TEST_CASE("dangling faces: a facet that is a flap of two surfaces stays that of one, and holds what ends on it",
          "[arrangement]") {
  // Two tetrahedra on either side of the edge (0, 1), of surfaces 0 and 1, share a flap; surface 2 ends on it.
  std::vector<Vec3> points = tetrahedron_and_points_beside(0.01);
  points.push_back({0, -1, 0.5});
  points.push_back({0, -0.5, 1});
  points.push_back({0.7, -3, -3});
  Complex complex = complex_of(points, with(sides, {{{0, 6, 1}, {1}},
                                                    {{0, 1, 7}, {1}},
                                                    {{1, 6, 7}, {1}},
                                                    {{0, 7, 6}, {1}},
                                                    {{0, 1, 4}, {0, 1}},
                                                    {{1, 8, 4}, {2}}}));
  CHECK(cut_dangling_faces(complex, 0.02).n_pieces == 1);
  REQUIRE(complex.facets.size() == 10);
  CHECK(complex.origins.of(8).size() == 1);
}

TEST_CASE("dangling faces: a facet that another surface has too stays that one's", "[arrangement]") {
  Complex complex = complex_of(tetrahedron_and_points_beside(0.01), with(sides, {{{0, 1, 4}, {0, 1}}}));
  CHECK(cut_dangling_faces(complex, 0.02).n_pieces == 1);
  REQUIRE(complex.facets.size() == 5);
  REQUIRE(complex.origins.of(4).size() == 1);
  CHECK(complex.origins.of(4)[0].surface == 1);
}

TEST_CASE("holes: a surface that ends all about a low facet of another has it too", "[arrangement]") {
  const auto about = [](double height, bool turned) {
    const Triangle middle = turned ? Triangle{0, 2, 1} : Triangle{0, 1, 2};
    return complex_of({{0, 0, 0}, {1, 0, 0}, {0.5, height, 0}, {0.5, -1, 0}, {2, 1, 0}, {-1, 1, 0}},
                      {{middle, {1}}, {{1, 0, 3}, {0}}, {{2, 1, 4}, {0}}, {{0, 2, 5}, {0}}});
  };
  for (const bool turned : {false, true}) {
    Complex low = about(0.01, turned);
    CHECK(fill_holes(low, 0.02) == 1);
    CHECK(low.origins.of(0).size() == 2);
    CHECK(n_turned(low, 0) == 0);
    CHECK(fill_holes(low, 0.02) == 0);
  }
  Complex high = about(0.1, false);
  CHECK(fill_holes(high, 0.02) == 0);
}

TEST_CASE("holes: a surface that goes on at an edge of the facet has no hole there", "[arrangement]") {
  Complex complex = complex_of({{0, 0, 0}, {1, 0, 0}, {0.5, 0.01, 0}, {0.5, -1, 0}, {2, 1, 0}},
                               {{{0, 1, 2}, {1}}, {{1, 0, 3}, {0}}, {{2, 1, 4}, {0}}});
  CHECK(fill_holes(complex, 0.02) == 0);
}

TEST_CASE("holes: a surface with a thin notch before a facet of another has it too", "[arrangement]") {
  // Found by seed 970469 of the random models (--light): a fault was joined to its twin, which ended on either side of
  // a strip of a third fault, and went up to the border of both.
  const auto notch = [](double mouth, bool turned) {
    const Triangle middle = turned ? Triangle{0, 2, 1} : Triangle{0, 1, 2};
    return complex_of({{0, 0, 0}, {1, 0, 0}, {1, mouth, 0}, {0.5, -1, 0}, {0.5, 1, 0}},
                      {{middle, {1}}, {{1, 0, 3}, {0}}, {{0, 2, 4}, {0}}});
  };
  for (const bool turned : {false, true}) {
    Complex thin = notch(0.03, turned);
    CHECK(fill_holes(thin, 0.02) == 1);
    CHECK(thin.origins.of(0).size() == 2);
    CHECK(n_turned(thin, 0) == 0);
    CHECK(surface_ends(thin).size() == 3 + 4 + 1);  // surface 1; surface 0 outside, and at the mouth
    CHECK(fill_holes(thin, 0.02) == 0);
    Complex wide = notch(0.05, turned);
    CHECK(fill_holes(wide, 0.02) == 0);
  }
}

TEST_CASE("pockets: the wall that stays names the triangle that lay on it, not the one whose middle is nearest",
          "[arrangement]") {
  // Of the facets over the large one, (3, 4, 0) has its middle nearest to the large one's, and (3, 2, 4) lies there.
  Complex complex = complex_of(
      {{0, 0, 0}, {100, 0, 0}, {0, 10, 0}, {30, 3.2, 0.01}, {36, 3.3, 0.01}},
      {{{0, 2, 1}, {0}}, {{0, 4, 3}, {1}}, {{2, 3, 4}, {1}}, {{1, 2, 4}, {1}}, {{0, 1, 4}, {1}}, {{2, 0, 3}, {1}}});
  CHECK(close_pockets(complex, 0.1, 2, {}).n_pockets == 1);
  REQUIRE(complex.facets.size() == 1);
  REQUIRE(complex.origins.of(0).size() == 2);
  CHECK(complex.origins.of(0)[1].surface == 1);
  CHECK(complex.origins.of(0)[1].triangle == 2);
}

TEST_CASE("needles: one whose border crosses itself in its plane is split as its border is well seen",
          "[arrangement]") {
  // The vertex 3 is to go on the needle's long side, and lies beyond its third corner as seen along the normal.
  const std::vector<Vec3> points{
      {350, 213.5, 1706.46}, {2404.4, 487.2, 1692.76}, {2193.6, 460.8, 1694.28}, {2193.6, 461, 1696.35}};
  const auto split = split_facet(points, {0, 1, 2}, {0, 3, 1, 2}, {}, {});
  REQUIRE(split);
  REQUIRE(split->size() == 2);
  std::map<std::pair<VertexIndex, VertexIndex>, int> n_at;
  for (const Triangle& t : *split)
    for (std::size_t k = 0; k < 3; ++k) ++n_at[{t[k], t[(k + 1) % 3]}];
  for (const auto& [a, b] : {std::pair{0u, 3u}, std::pair{3u, 1u}, std::pair{1u, 2u}, std::pair{2u, 0u}})
    CHECK(n_at[{a, b}] == 1);
}
