// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "recover/rounding/chebyshev_centre.hpp"

using namespace geomesh::recover;

namespace {

/// Heights over random planes about 0, the least of them `flat` above theirs.
std::vector<LinearHeight> random_heights(std::mt19937& random, unsigned n_directions, unsigned n, double flat) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> height(0.1, 1);
  std::vector<LinearHeight> out;
  for (unsigned i = 0; i < n; ++i) {
    LinearHeight h{height(random), {}};
    double squares = 0;
    for (unsigned k = 0; k < n_directions; ++k) h.slope[k] = normal(random), squares += h.slope[k] * h.slope[k];
    for (unsigned k = 0; k < n_directions; ++k) h.slope[k] /= std::sqrt(squares);
    out.push_back(h);
  }
  for (unsigned k = 0; k < n_directions; ++k)  // a box closes it
    for (const double side : {-1.0, 1.0}) {
      LinearHeight h{1, {}};
      h.slope[k] = side;
      out.push_back(h);
    }
  out[0].at = flat;
  return out;
}

using Row = std::array<double, 5>;  ///< coefficients of four unknowns at most, then the right side

/// By elimination with row pivots. False where that divides by next to nothing.
bool solve(std::vector<Row>& rows, std::array<double, 4>& x) {
  const std::size_t n = rows.size();
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c; r < n; ++r)
      if (std::fabs(rows[r][c]) > std::fabs(rows[pivot][c])) pivot = r;
    if (std::fabs(rows[pivot][c]) < 1e-9) return false;
    std::swap(rows[c], rows[pivot]);
    for (std::size_t r = 0; r < n; ++r) {
      if (r == c) continue;
      const double factor = rows[r][c] / rows[c][c];
      for (std::size_t k = c; k < n; ++k) rows[r][k] -= factor * rows[c][k];
      rows[r][4] -= factor * rows[c][4];
    }
  }
  for (std::size_t c = 0; c < n; ++c) x[c] = rows[c][4] / rows[c][c];
  return true;
}

/// The greatest least height, as that of all vertices of the program: the places where n_directions + 1 heights are
/// equal to one that no height is below.
double by_all_vertices(const std::vector<LinearHeight>& heights, unsigned n_directions) {
  const unsigned size = n_directions + 1, n = static_cast<unsigned>(heights.size());
  double greatest = least_height(heights, {});
  std::vector<unsigned> chosen(size);
  const auto look = [&](auto&& self, unsigned depth, unsigned from) -> void {
    if (depth < size) {
      for (unsigned i = from; i < n; ++i) chosen[depth] = i, self(self, depth + 1, i + 1);
      return;
    }
    std::vector<Row> rows;
    for (const unsigned i : chosen) {
      Row row{};
      for (unsigned k = 0; k < n_directions; ++k) row[k] = heights[i].slope[k];
      row[n_directions] = -1;
      row[4] = -heights[i].at;
      rows.push_back(row);
    }
    std::array<double, 4> x{};
    if (!solve(rows, x)) return;
    std::array<double, 3> place{};
    for (unsigned k = 0; k < n_directions; ++k) place[k] = x[k];
    greatest = std::max(greatest, least_height(heights, place));
  };
  look(look, 0, 0);
  return greatest;
}

}  // namespace

TEST_CASE("the centre of a star is where the least height is greatest, as all vertices of the program tell",
          "[recover]") {
  std::mt19937 random(1);
  for (unsigned n_directions = 1; n_directions <= 3; ++n_directions)
    for (unsigned seed = 0; seed < 60; ++seed)
      for (const double flat : {0.5, 1e-6, 1e-15}) {
        const auto heights = random_heights(random, n_directions, 2 + seed % 12, flat);
        const std::array<double, 3> centre = chebyshev_centre(heights, n_directions, 100);
        CHECK(least_height(heights, centre) == Approx(by_all_vertices(heights, n_directions)).epsilon(1e-9));
        CHECK(least_height(heights, centre) >= least_height(heights, {}));
      }
}

TEST_CASE("between two planes that face each other the centre is half-way, however near they are", "[recover]") {
  for (const double apart : {1.0, 1e-8, 1e-15}) {
    const std::vector<LinearHeight> heights{{apart / 4, {0, 0, 1}}, {3 * apart / 4, {0, 0, -1}},
                                            {1, {1, 0, 0}},         {1, {-1, 0, 0}},
                                            {1, {0, 1, 0}},         {1, {0, -1, 0}}};
    CHECK(least_height(heights, chebyshev_centre(heights, 3, 100)) == Approx(apart / 2).epsilon(1e-6));
  }
}
