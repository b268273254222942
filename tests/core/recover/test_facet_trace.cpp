// SPDX-License-Identifier: GPL-3.0-or-later
// Points on the sides of facets in one plane, as where surfaces are sampled before they are meshed: each three of a
// side are on one line but for rounding, so parts of no width lie beside it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <random>
#include <string>

#include "corpus_builder.hpp"
#include "geomesh/core/tetrahedralize.hpp"

using namespace geomesh;
using namespace geomesh::test;

namespace {

/// Triangles of a bent grid in the plane of one x, with points on their sides, in a box with points about them.
class SampledGrid {
 public:
  explicit SampledGrid(unsigned seed) : random_(seed) {
    std::vector<Vec3> corners;
    for (unsigned i = 0; i <= n_squares; ++i)
      for (unsigned j = 0; j <= n_squares; ++j)
        corners.push_back({x, 200 * (i + 0.5 * unit() - 0.25), 60 * (j + 0.5 * unit() - 0.25)});
    const auto at = [&](unsigned i, unsigned j) { return builder_.vertex(corners[i * (n_squares + 1) + j]); };
    for (unsigned i = 0; i < n_squares; ++i)
      for (unsigned j = 0; j < n_squares; ++j) {
        add({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        add({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    for (int k = 0; k < 60; ++k)
      builder_.isolated_point({x + (k % 2 ? 400 : -400) * unit(), 1200 * unit() - 200, 400 * unit() - 80});
    builder_.box({x - 500, -300, -200}, {x + 500, 1100, 400});
  }

  const PiecewiseLinearComplex& plc() const { return builder_.plc; }

 private:
  static constexpr double x = -5291.109375;
  static constexpr unsigned n_squares = 4;  // a side

  double unit() { return static_cast<double>(random_() % (1u << 24)) / (1u << 24); }

  /// Of the side of two corners, from the lower one to the higher.
  const std::vector<Vec3>& points_between(VertexIndex low, VertexIndex high) {
    const auto [side, is_new] = between_.try_emplace({low, high});
    const Vec3 a = builder_.plc.points[low], way = builder_.plc.points[high] - a;
    const unsigned n = is_new ? 1 + random_() % 5 : 0;
    for (unsigned k = 1; k <= n; ++k) side->second.push_back(a + (k + 0.4 * unit() - 0.2) / (n + 1) * way);
    return side->second;
  }

  void add(const Triangle& t) {
    std::vector<Vec3> loop;
    for (unsigned k = 0; k < 3; ++k) {
      const VertexIndex a = t[k], b = t[(k + 1) % 3];
      std::vector<Vec3> between = points_between(std::min(a, b), std::max(a, b));
      if (a > b) std::reverse(between.begin(), between.end());
      loop.push_back(builder_.plc.points[a]);
      loop.insert(loop.end(), between.begin(), between.end());
    }
    builder_.polygon(loop);
  }

  std::mt19937 random_;
  PlcBuilder builder_;
  std::map<std::array<VertexIndex, 2>, std::vector<Vec3>> between_;
};

}  // namespace

TEST_CASE("facets with parts of no width along their sides are recovered at the first attempt", "[recover]") {
  for (unsigned seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    std::string begun_again;
    RunContext context;
    context.log = [&](LogLevel, std::string_view text) {
      if (text.find("attempt ") != text.npos) begun_again += text;
    };
    const ConstrainedTetrahedralization mesh = tetrahedralize(SampledGrid(seed).plc(), {}, context);
    CHECK(begun_again.empty());
    CHECK(mesh.recovery.steiner_on_facets == 0);
  }
}
