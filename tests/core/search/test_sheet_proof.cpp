// SPDX-License-Identifier: MIT
// The proof that a surface goes on under a whole triangle, against dense samples.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "quality/measure/shape.hpp"
#include "search/sheet_proof.hpp"

using namespace geomesh;
using search::Over;
using search::PreparedTriangle;
using search::SheetProof;

namespace {

using Corners = std::array<Vec3, 3>;
constexpr int n_squares = 12;

/// A wavy surface over the square from -1.2 to 1.2.
struct Grid {
  explicit Grid(double height) {
    const auto at = [&](int i, int j) {
      const double x = -1.2 + 2.4 * i / n_squares, y = -1.2 + 2.4 * j / n_squares;
      return Vec3{x, y, height * std::sin(3 * x) * std::cos(2 * y)};
    };
    for (int i = 0; i < n_squares; ++i)
      for (int j = 0; j < n_squares; ++j)
        for (const Corners& t :
             {Corners{at(i, j), at(i + 1, j), at(i + 1, j + 1)}, Corners{at(i, j + 1), at(i, j), at(i + 1, j + 1)}})
          items.push_back({t, 0, 0});
  }
  /// Judged by all of its triangles.
  bool is_under(const Corners& t, double limit) const {
    const std::vector<std::uint8_t> open = search::find_open_edges(items);
    SheetProof proof(t, limit);
    bool has_border = !proof.is_possible();
    for (std::size_t i = 0; i < items.size(); ++i) {
      const PreparedTriangle prepared(items[i].corners);
      has_border |= proof.judge({&prepared, open[i]}) == Over::border;
    }
    return !has_border && proof.is_proven();
  }
  double sampled(const Corners& t) const {
    constexpr int n = 30;
    double largest = 0;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) {
        const double u = static_cast<double>(i) / n, v = static_cast<double>(j) / n;
        const Vec3 p = (1 - u - v) * t[0] + u * t[1] + v * t[2];
        double nearest = 1e9;
        for (const auto& item : items)
          nearest = std::min(nearest, distance(p, PreparedTriangle(item.corners).closest_to(p)));
        largest = std::max(largest, nearest);
      }
    return largest;
  }
  std::vector<search::ClosestPointTrees::Item> items;
};

}  // namespace

TEST_CASE("What a surface goes on under is within the limit of it, by dense samples", "[search]") {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> u(-1, 1);
  const Grid grid(0.08);
  std::size_t proven = 0, beyond = 0, missed = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const auto corner = [&] { return Vec3{1.3 * u(random), 1.3 * u(random), 0.08 * u(random)}; };
    const Corners t{corner(), corner(), corner()};
    const double limit = 0.03 + 0.2 * std::abs(u(random)), truth = grid.sampled(t);
    const bool is_proven = grid.is_under(t, limit);
    if (is_proven) CHECK(truth <= limit);
    proven += is_proven;
    beyond += truth > limit;
    const bool is_over =
        std::all_of(t.begin(), t.end(), [](const Vec3& p) { return std::abs(p.x) < 1.15 && std::abs(p.y) < 1.15; });
    missed += !is_proven && is_over && truth < 0.7 * limit;
  }
  CHECK(proven > 50);
  CHECK(beyond > 50);
  CHECK(missed < 15);
}

TEST_CASE("A hole, a border and a crease under a triangle leave it unproven", "[search]") {
  const Corners t{Vec3{-0.9, -0.8, 0}, Vec3{0.9, -0.7, 0}, Vec3{0, 0.9, 0}};
  Grid flat(0);
  CHECK(flat.is_under(t, 0.01));
  const Corners outside{Vec3{-0.9, -0.8, 0}, Vec3{1.5, -0.7, 0}, Vec3{0, 0.9, 0}};
  CHECK_FALSE(flat.is_under(outside, 0.01));
  const Corners above{Vec3{-0.9, -0.8, 0.02}, Vec3{0.9, -0.7, 0.02}, Vec3{0, 0.9, 0.02}};
  CHECK_FALSE(flat.is_under(above, 0.01));
  CHECK(flat.is_under(above, 0.03));

  Grid folded = flat;
  for (auto& item : folded.items)
    for (Vec3& p : item.corners) p.z = -0.9 * std::abs(p.x);
  const Corners chord{Vec3{-0.3, -0.2, -0.27}, Vec3{0.3, -0.2, -0.27}, Vec3{0, 0.4, 0}};
  CHECK_FALSE(folded.is_under(chord, 0.3));

  Grid holed = flat;
  holed.items.erase(holed.items.begin() + holed.items.size() / 2 + n_squares);  // near the middle
  CHECK_FALSE(holed.is_under(t, 0.01));
}

TEST_CASE("Edges are open at borders, at creases and where three triangles meet", "[search]") {
  const Vec3 a{0, 0, 0}, b{0, 1, 0}, left{-1, 0.5, 0}, right{1, 0.5, 0}, up{0, 0.5, 1};
  const auto open = [](std::vector<Corners> triangles) {
    std::vector<search::ClosestPointTrees::Item> items;
    for (const Corners& t : triangles) items.push_back({t, 0, 0});
    return search::find_open_edges(items);
  };
  using Flags = std::vector<std::uint8_t>;
  CHECK(open({{a, b, left}}) == Flags{7});
  CHECK(open({{a, b, left}, {b, a, right}}) == Flags{6, 6});
  CHECK(open({{a, b, left}, {right, a, b}}) == Flags{6, 5});  // whichever way they turn
  CHECK(open({{a, b, left}, {b, a, up}}) == Flags{7, 7});
  CHECK(open({{a, b, left}, {b, a, right}, {a, b, up}}) == Flags{7, 7, 7});
  CHECK(open({{a, b, left}, {a, b, Vec3{-1, 0.6, 0}}}) == Flags{7, 7});  // folded back
}
