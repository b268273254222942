// SPDX-License-Identifier: MIT
// The proof of a distance against dense samples, on triangles by a plane, over a crease and by chance.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "quality/measure/shape.hpp"
#include "search/closest_point.hpp"
#include "search/cover_proof.hpp"
#include "search/proven_distance.hpp"

using namespace geomesh;
using search::Corners;
using search::DistanceProver;

namespace {

double distance_to(const Vec3& p, const std::vector<Corners>& set) {
  double d = std::numeric_limits<double>::infinity();
  for (const Corners& t : set) d = std::min(d, distance(p, search::closest_on_triangle(p, t[0], t[1], t[2])));
  return d;
}

/// Largest distance over a lattice of points of the triangle.
double sampled(const Corners& t, const std::vector<Corners>& set) {
  constexpr int n = 40;
  double largest = 0;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      const double u = static_cast<double>(i) / n, v = static_cast<double>(j) / n;
      const Vec3 p = (1 - u - v) * t[0] + u * t[1] + v * t[2];
      largest = std::max(largest, distance_to(p, set));
    }
  return largest;
}

/// The graph of a roof, 0 at x = 0 and falling to both sides, in four triangles.
std::vector<Corners> roof(double slope) {
  const Vec3 a{0, -2, 0}, b{0, 2, 0}, c{2, -2, -2 * slope}, d{2, 2, -2 * slope}, e{-2, -2, -2 * slope},
      f{-2, 2, -2 * slope};
  return {{a, c, d}, {a, d, b}, {a, b, f}, {a, f, e}};
}

}  // namespace

TEST_CASE("A triangle over a crease is within what its middle says, and not within less", "[search]") {
  // From (-1, 0) to (1, 0) over the roof: at its corners 0.1 below the ridge's height, in the middle 0.1 below the
  // ridge.
  const std::vector<Corners> set = roof(0.1);
  const Corners chord{Vec3{-1, -0.2, -0.1}, Vec3{1, -0.2, -0.1}, Vec3{0, 0.4, -0.1}};
  const double truth = sampled(chord, set);
  CHECK(truth == Approx(0.1 / std::sqrt(1.01)).epsilon(0.01));
  CHECK(DistanceProver(1.02 * truth).is_within(chord, set));
  CHECK_FALSE(DistanceProver(0.98 * truth).is_within(chord, set));
  // With a bump between the samples that a lattice of corners, middles and centroid would take.
  const Corners flat{Vec3{-2, -2, 0}, Vec3{2, -2, 0}, Vec3{0, 2, 0}};
  CHECK_FALSE(DistanceProver(0.1).is_within(flat, roof(0.1)));
}

TEST_CASE("A triangle of the sheet that is over all of a triangle is told, and none over a crease", "[search]") {
  const auto flaps = [](double height) {
    return std::vector<Corners>{{{{-2, -2, 0}, {2, 0, 0}, {-2, 2, 0}}},
                                {{{2, 0, 0}, {6, 2, height}, {-2, 2, 0}}},
                                {{{2, 0, 0}, {-2, -2, 0}, {6, -2, height}}}};
  };
  const Corners over_two{{{0, 0, 0.1}, {1, 1.5, 0.1}, {0, 1.2, 0.1}}};
  DistanceProver prover(0.5);
  CHECK(prover.is_within(over_two, flaps(0)));
  CHECK(prover.sheet_row() < 2);
  CHECK(prover.is_within(over_two, flaps(-0.2)));
  CHECK(prover.sheet_row() < 2);
  DistanceProver far(0.05);
  CHECK_FALSE(far.is_within(over_two, flaps(0)));
  CHECK(far.sheet_row() == geomesh::no_index);
  const std::vector<Corners> crease{{{{-2, -2, 0}, {2, 0, 0}, {-2, 2, 0}}}, {{{2, 0, 0}, {1, 3, 4}, {-2, 2, 0}}}};
  CHECK(prover.is_within({{{0.5, 0.6, 0.1}, {0.7, 0.8, 0.1}, {0.4, 0.8, 0.1}}}, crease));
  CHECK(prover.sheet_row() == geomesh::no_index);
}

TEST_CASE("What is proven to be within a distance is, by dense samples", "[search]") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto triangle = [&](double height) {
    return Corners{Vec3{u(random), u(random), height * u(random)}, Vec3{u(random), u(random), height * u(random)},
                   Vec3{u(random), u(random), height * u(random)}};
  };
  std::size_t proven = 0, refused = 0, missed = 0;
  for (int trial = 0; trial < 400; ++trial) {
    // A folded grid and a triangle above it.
    std::vector<Corners> set;
    std::array<std::array<double, 4>, 4> z{};
    for (auto& row : z)
      for (double& h : row) h = 0.1 * u(random);
    const auto at = [&](int i, int j) {
      return Vec3{-1.2 + 0.8 * i, -1.2 + 0.8 * j, z[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]};
    };
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        set.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        set.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    const Corners t = triangle(0.1);
    const double limit = 0.05 + 0.1 * std::abs(u(random)), truth = sampled(t, set);
    const bool is_proven = DistanceProver(limit).is_within(t, set);
    if (is_proven) CHECK(truth <= limit * (1 + 1e-9));
    proven += is_proven;
    refused += truth > limit;
    missed += !is_proven && truth < 0.9 * limit;
  }
  CHECK(proven > 50);
  CHECK(refused > 50);
  CHECK(missed < 20);  // what is well within is seldom left open
}

TEST_CASE("Line pieces are triangles with two equal corners", "[search]") {
  const std::vector<Corners> bent{{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 0, 0}},
                                  {Vec3{1, 0, 0}, Vec3{2, 0.2, 0}, Vec3{2, 0.2, 0}}};
  const Corners chord{Vec3{0, 0, 0}, Vec3{2, 0.2, 0}, Vec3{2, 0.2, 0}};
  const double sag = 0.1 * std::cos(std::atan(0.1));
  CHECK(DistanceProver(1.02 * sag).is_within(chord, bent));
  CHECK_FALSE(DistanceProver(0.97 * sag).is_within(chord, bent));
}

TEST_CASE("What is proven of one item against a tree is within the distance, by dense samples", "[search]") {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> u(-1, 1);
  std::size_t proven = 0, refused = 0, missed = 0;
  for (int trial = 0; trial < 300; ++trial) {
    // A folded grid of many triangles, and a triangle above it that is large, or a needle.
    constexpr int n = 12;
    std::vector<std::vector<double>> z(n + 1, std::vector<double>(n + 1));
    for (auto& row : z)
      for (double& h : row) h = 0.1 * u(random);
    const auto at = [&](int i, int j) {
      return Vec3{-1.2 + 2.4 * i / n, -1.2 + 2.4 * j / n, z[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]};
    };
    std::vector<search::ClosestPointTrees::Item> items;
    std::vector<Corners> set;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        for (const Corners& t :
             {Corners{at(i, j), at(i + 1, j), at(i + 1, j + 1)}, Corners{at(i, j), at(i + 1, j + 1), at(i, j + 1)}}) {
          set.push_back(t);
          items.push_back({t, 0, 0});
        }
    const search::ClosestPointTrees tree(std::move(items), 1);
    Corners t{Vec3{u(random), u(random), 0.05 * u(random)}, Vec3{u(random), u(random), 0.05 * u(random)},
              Vec3{u(random), u(random), 0.05 * u(random)}};
    if (trial % 3 == 0) t[2] = 0.5 * (t[0] + t[1]) + 1e-9 * Vec3{u(random), u(random), u(random)};
    if (trial % 3 == 1) t[2] = t[1];
    const double limit = 0.04 + 0.1 * std::abs(u(random)), truth = sampled(t, set);
    const search::Cover cover = search::CoverProver(tree, limit).judge(t, 0);
    if (cover.is_proven) CHECK(truth <= limit * (1 + 1e-9));
    CHECK(cover.farthest == Approx(distance_to(cover.place, set)).margin(1e-12));
    const std::vector<std::uint8_t> open = search::find_open_edges(tree.items());
    CHECK(search::CoverProver(tree, limit, open).judge(t, 0).is_proven == cover.is_proven);
    proven += cover.is_proven;
    refused += truth > limit;
    missed += !cover.is_proven && truth < 0.97 * limit;
  }
  CHECK(proven > 50);
  CHECK(refused > 50);
  CHECK(missed == 0);
}

TEST_CASE("A large triangle is proven on small ones in its plane, and a hole in them is found", "[search]") {
  constexpr int n = 40;
  const double limit = 1e-5;
  for (const bool holed : {false, true}) {
    std::vector<search::ClosestPointTrees::Item> items;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const auto at = [&](int a, int b) { return Vec3{static_cast<double>(a) / n, static_cast<double>(b) / n, 0.3}; };
        items.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1)}, 0, 0});
        if (!holed || i != 17 || j != 9) items.push_back({{at(i, j), at(i + 1, j + 1), at(i, j + 1)}, 0, 0});
      }
    const search::ClosestPointTrees tree(std::move(items), 1);
    const search::Cover cover =
        search::CoverProver(tree, limit).judge({Vec3{0, 0, 0.3}, Vec3{1, 0, 0.3}, Vec3{0.2, 1, 0.3}}, 0);
    CHECK(cover.is_proven == !holed);
    CHECK((cover.farthest > limit) == holed);
  }
}

TEST_CASE("A triangle over many long needles is proven, however small the limit", "[search]") {
  // Their boxes overlap by far more than they do: about each piece are boxes of many.
  constexpr unsigned n = 400;
  const Vec3 along{100, 60, 7}, across{-30, 50, 11};
  std::vector<search::ClosestPointTrees::Item> items;
  for (unsigned k = 0; k < n; ++k) {
    const double s = static_cast<double>(k) / n, t = static_cast<double>(k + 1) / n;
    const Vec3 a = s * across, b = t * across;
    items.push_back({{a, a + along, b + along}, 0, 2 * k});
    items.push_back({{a, b + along, b}, 0, 2 * k + 1});
  }
  const search::ClosestPointTrees trees(items, 1);
  const Corners item{0.05 * along + 0.1 * across, 0.9 * along + 0.3 * across, 0.3 * along + 0.9 * across};
  for (const double limit : {1.0, 1e-2, 1e-4, 1e-6}) {
    INFO("limit " << limit);
    CHECK(search::CoverProver(trees, limit).judge(item, 0).is_proven);
  }
}
