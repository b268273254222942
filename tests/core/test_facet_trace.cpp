// SPDX-License-Identifier: MIT
// Points on the sides of facets in one plane, as where surfaces are sampled before they are meshed: each three of a side are on one line but for
// rounding, so parts of no width lie beside it.
#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <random>
#include <string>

#include "corpus_run.hpp"

using namespace geomesh;
using namespace geomesh::test;

namespace {

constexpr VertexIndex n_squares = 4;  // a side

/// Triangles of a bent grid in the plane of one x, with points on their sides, in a box with points about them.
class SampledGrid {
 public:
  explicit SampledGrid(unsigned seed) : random_(seed) {
    for (unsigned i = 0; i <= n_squares; ++i)
      for (unsigned j = 0; j <= n_squares; ++j) plc_.points.push_back({x, 200 * (i + 0.5 * unit() - 0.25), 60 * (j + 0.5 * unit() - 0.25)});
    for (unsigned i = 0; i < n_squares; ++i)
      for (unsigned j = 0; j < n_squares; ++j) {
        add({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
        add({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
      }
    for (int k = 0; k < 60; ++k) {
      plc_.isolated_points.push_back(static_cast<VertexIndex>(plc_.points.size()));
      plc_.points.push_back({x + (k % 2 ? 400 : -400) * unit(), 1200 * unit() - 200, 400 * unit() - 80});
    }
    add_box({x - 500, -300, -200}, {x + 500, 1100, 400});
  }

  PiecewiseLinearComplex take() { return std::move(plc_); }

 private:
  static constexpr double x = -5291.109375;

  double unit() { return static_cast<double>(random_() % (1u << 24)) / (1u << 24); }
  static VertexIndex id(VertexIndex i, VertexIndex j) { return i * (n_squares + 1) + j; }

  /// From the lower vertex to the higher.
  const std::vector<VertexIndex>& points_between(VertexIndex a, VertexIndex b) {
    const auto [at, is_new] = between_.try_emplace({a, b});
    const unsigned n = is_new ? 1 + random_() % 5 : 0;
    for (unsigned k = 1; k <= n; ++k) {
      at->second.push_back(static_cast<VertexIndex>(plc_.points.size()));
      plc_.points.push_back(plc_.points[a] + (k + 0.4 * unit() - 0.2) / (n + 1) * (plc_.points[b] - plc_.points[a]));
    }
    return at->second;
  }

  void add(const Triangle& t) {
    std::vector<std::vector<VertexIndex>> loops(1);
    for (unsigned k = 0; k < 3; ++k) {
      const VertexIndex a = t[k], b = t[(k + 1) % 3];
      std::vector<VertexIndex> between = points_between(std::min(a, b), std::max(a, b));
      if (a > b) std::reverse(between.begin(), between.end());
      loops[0].push_back(a);
      loops[0].insert(loops[0].end(), between.begin(), between.end());
    }
    plc_.add_polygon(loops);
  }

  void add_box(const Vec3& low, const Vec3& high) {
    const auto first = static_cast<VertexIndex>(plc_.points.size());
    for (unsigned k = 0; k < 8; ++k) plc_.points.push_back({k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z});
    for (const std::array<VertexIndex, 4>& side : {std::array<VertexIndex, 4>{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
      std::vector<std::vector<VertexIndex>> loops(1);
      for (const VertexIndex v : side) loops[0].push_back(first + v);
      plc_.add_polygon(loops);
    }
  }

  std::mt19937 random_;
  PiecewiseLinearComplex plc_;
  std::map<std::array<VertexIndex, 2>, std::vector<VertexIndex>> between_;
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
    const ConstrainedTetrahedralization mesh = tetrahedralize(SampledGrid(seed).take(), {}, context);
    CHECK(begun_again.empty());
    CHECK(mesh.recovery.steiner_on_facets == 0);
  }
}
