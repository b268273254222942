// SPDX-License-Identifier: GPL-3.0-or-later
// Holes that surfaces got before facets of others, where facets of theirs vanished.
#include <catch2/catch.hpp>
#include <map>

#include "arrangement/pockets/fill_holes.hpp"

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
