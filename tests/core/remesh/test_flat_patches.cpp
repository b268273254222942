// SPDX-License-Identifier: GPL-3.0-or-later
// Changes within plane patches, which need no search for distances.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "geomesh/core/predicates.hpp"
#include "remesh/tolerance/flat_patches.hpp"

using namespace geomesh;
using namespace geomesh::remesh;

namespace {

constexpr double rounding = 1e-9;

/// A place in the plane of patch 0, which leans.
Vec3 at(double x, double y) { return {431000 + x, 6512000 + y, -1500 + 0.25 * x - 0.5 * y}; }

/// Patch 0 lies in a plane; patch 1 is bent by a tenth of a degree.
FlatPatches patches() {
  const Vec3 off{0, 0, 0.2};
  const search::TriangleSurfaces original({{{at(0, 0), at(100, 0), at(100, 100)}, 0, 0},
                                           {{at(0, 0), at(100, 100), at(0, 100)}, 0, 1},
                                           {{at(0, 0), at(100, 0), at(100, 100)}, 1, 2},
                                           {{at(0, 0), at(100, 100), at(0, 100) + off}, 1, 3}},
                                          2);
  return {original, 2, rounding};
}

/// The faces about p, all the way round or half of it, over the same corners.
std::vector<SurfaceFace> star(const Vec3& p, unsigned n, double turn, Index patch = 0) {
  std::vector<SurfaceFace> out;
  const auto corner = [&](unsigned k) {
    const double angle = turn * k / n, reach = 10 + k % n % 3;
    return at(50 + reach * std::cos(angle), 50 + reach * std::sin(angle));
  };
  for (unsigned k = 0; k < n; ++k) out.push_back({{p, corner(k), corner(k + 1)}, patch});
  return out;
}

}  // namespace

TEST_CASE("A vertex may move within the star of its plane, not out of it or off the plane", "[refine]") {
  constexpr double whole = 2 * std::numbers::pi;
  const FlatPatches flat = patches();
  const SurfacePart before{star(at(50, 50), 7, whole), {}};
  CHECK(flat.is_flat(0));
  CHECK_FALSE(flat.is_flat(1));
  CHECK(flat.cover_the_same(before, {star(at(53, 48), 7, whole), {}}));
  CHECK_FALSE(flat.cover_the_same(before, {star(at(50, 50) + Vec3{0, 0, 1e-6}, 7, whole), {}}));
  CHECK_FALSE(flat.cover_the_same({star(at(50, 50), 7, whole, 1), {}}, {star(at(53, 48), 7, whole, 1), {}}));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(35, 65);
  std::size_t n_in = 0;
  for (unsigned trial = 0; trial < 400; ++trial) {
    const double x = place(random), y = place(random);
    const std::vector<SurfaceFace> after = star(at(x, y), 7, whole);
    bool sees_all = true;
    for (const SurfaceFace& f : after) {
      const auto& [p, a, b] = f.corners;
      sees_all = sees_all && orient2d({p.x, p.y}, {a.x, a.y}, {b.x, b.y}) == Sign::positive;
    }
    CHECK(flat.cover_the_same(before, {after, {}}) == sees_all);
    n_in += sees_all;
  }
  CHECK(n_in > 50);
  CHECK(n_in < 350);
}

TEST_CASE("A vertex of a straight border may move along it, not off it and not past its ends", "[refine]") {
  const FlatPatches flat = patches();
  const Vec3 left = at(40, 50), right = at(60, 50), middle = at(50, 50);
  const auto half = [&](const Vec3& p) {
    return std::vector<SurfaceFace>{{{p, right, at(50, 60)}, 0}, {{p, at(50, 60), left}, 0}};
  };
  const auto curves = [&](const Vec3& p) { return std::vector<CurvePiece>{{p, left, 4}, {p, right, 4}}; };
  const SurfacePart before{half(middle), curves(middle)};
  CHECK(flat.cover_the_same(before, {half(at(54, 50)), curves(at(54, 50))}));
  CHECK_FALSE(flat.cover_the_same(before, {half(at(50, 51)), curves(at(50, 51))}));  // the border would be bent
  CHECK_FALSE(flat.cover_the_same({{}, curves(middle)}, {{}, curves(at(70, 50))}));  // passed twice
  CHECK_FALSE(flat.cover_the_same({{}, curves(middle)}, {{}, {{left, at(50, 70), 4}}}));
  const SurfacePart one{{{{left, right, at(50, 60)}, 0}}, {{left, right, 4}}};  // the vertex goes
  CHECK(flat.cover_the_same(before, one));
  CHECK(flat.cover_the_same(one, before));
}
