// SPDX-License-Identifier: GPL-3.0-or-later
// Conforming mode where it promises success: facets that meet at 90 degrees or more, segments that meet at 60 or more.
#include <array>
#include <catch2/catch.hpp>
#include <random>

#include "corpus_builder.hpp"
#include "corpus_run.hpp"
#include "corpus_transform.hpp"

using namespace geomesh;
using namespace geomesh::test;

namespace {

using Random = std::mt19937_64;

double uniform(Random& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }
/// A whole number from low to high.
double whole(Random& random, double low, double high) { return low + std::floor(uniform(random) * (high - low + 1)); }

/// Blocks of random rock in a grid of n cells a side, whose planes are at whole numbers 1 to 64 apart: the rectangles
/// between cells of different rock, and about all of them, are the facets. So they meet at 90 or 180 degrees, in L, T
/// and cross junctions and about holes.
PiecewiseLinearComplex random_blocks(Random& random, int n) {
  std::array<std::vector<double>, 3> plane;
  for (auto& axis : plane) {
    axis = {0};
    for (int i = 0; i < n; ++i) axis.push_back(axis.back() + std::floor(std::exp2(6 * uniform(random))));
  }
  std::vector<int> rock(static_cast<std::size_t>(n * n * n));
  for (int& r : rock)
    r = static_cast<int>(whole(random, 0, 2));  // 0: none, so blocks may hang together by an edge or a corner
  const auto rock_at = [&](int i, int j, int k) {
    return std::min({i, j, k}) < 0 || std::max({i, j, k}) >= n ? 0
                                                               : rock[static_cast<std::size_t>((i * n + j) * n + k)];
  };
  PlcBuilder b;
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j < n; ++j)
        for (int k = 0; k < n; ++k) {
          const auto cell = [&](int along) {
            std::array<int, 3> c{};
            c[static_cast<std::size_t>(axis)] = along;
            c[static_cast<std::size_t>((axis + 1) % 3)] = j;
            c[static_cast<std::size_t>((axis + 2) % 3)] = k;
            return rock_at(c[0], c[1], c[2]);
          };
          if (cell(i - 1) == cell(i)) continue;
          const auto corner = [&](int dj, int dk) {
            Vec3 p;
            p[static_cast<std::size_t>(axis)] = plane[static_cast<std::size_t>(axis)][static_cast<std::size_t>(i)];
            p[static_cast<std::size_t>((axis + 1) % 3)] =
                plane[static_cast<std::size_t>((axis + 1) % 3)][static_cast<std::size_t>(j + dj)];
            p[static_cast<std::size_t>((axis + 2) % 3)] =
                plane[static_cast<std::size_t>((axis + 2) % 3)][static_cast<std::size_t>(k + dk)];
            return p;
          };
          b.polygon({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
        }
  return b.plc;
}

/// Octahedra about one centre: triangles of 60 degrees that meet at 109.5.
PiecewiseLinearComplex nested_octahedra(Random& random, int n) {
  PlcBuilder b;
  double radius = 1;
  for (int i = 0; i < n; ++i) {
    add_shell(b, sphere({0, 0, 0}, radius, 0));
    radius += std::floor(std::exp2(6 * uniform(random)));
  }
  return b.plc;
}

/// Vertices inside the rectangles and triangles of the model and anywhere in its box, where they lie on nothing else.
void add_random_vertices(PiecewiseLinearComplex& plc, Random& random, int n_free) {
  Box3 box;
  for (const Vec3& p : plc.points) box.add(p);
  const auto add = [&plc](const Vec3& p) {
    plc.points.push_back(p);
    return static_cast<VertexIndex>(plc.points.size() - 1);
  };
  for (Index f = 0; f < plc.n_facets(); ++f) {
    if (uniform(random) > 0.5 || plc.outer_loop(f).size() != 4) continue;
    const Vec3 a = plc.points[plc.outer_loop(f)[0]], c = plc.points[plc.outer_loop(f)[2]];
    Vec3 p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = a[i] + (whole(random, 1, 255) / 256) * (c[i] - a[i]);
    plc.facet_points.push_back({f, add(p)});
  }
  for (int i = 0; i < n_free; ++i) {
    // On a finer grid than the facets' planes, off all of them.
    Vec3 p;
    for (std::size_t k = 0; k < 3; ++k)
      p[k] = whole(random, box.min[k], box.max[k] - 1) + whole(random, 0, 4095) / 4096 + 1.0 / 8192;
    plc.isolated_points.push_back(add(p));
  }
}

/// Turned without rounding, and seven times as large.
Vec3 turned_exactly(const Vec3& p) {
  return {2 * p.x + 3 * p.y + 6 * p.z, 3 * p.x - 6 * p.y + 2 * p.z, 6 * p.x + 2 * p.y - 3 * p.z};
}

/// By whole numbers, so without rounding too.
Vec3 turned_to_utm(const Vec3& p) { return turned_exactly(p) + Vec3{512345, 5987654, -1234}; }

void check_that_nothing_is_given_up(const PiecewiseLinearComplex& plc) {
  const CorpusRun run = run_and_judge(plc, conforming_mode());
  CHECK(run.trouble == "");
  if (!run.mesh) return;
  CHECK(run.mesh->recovery.facets_not_recovered.empty());
  CHECK(run.mesh->delaunay);  // which the judge has verified
}

}  // namespace

TEST_CASE("conforming mode gives up nothing of right-angled blocks", "[recover][judged]") {
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    PiecewiseLinearComplex plc = random_blocks(random, static_cast<int>(1 + seed % 4));
    if (plc.n_facets() == 0) continue;
    add_random_vertices(plc, random, 40);
    check_that_nothing_is_given_up(mapped(plc, seed % 3 == 0   ? PointMap(turned_exactly)
                                               : seed % 3 == 1 ? PointMap(turned_to_utm)
                                                               : scaled(-20)));
  }
}

TEST_CASE("conforming mode gives up nothing of octahedra", "[recover][judged]") {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    PiecewiseLinearComplex plc = nested_octahedra(random, static_cast<int>(1 + seed % 4));
    add_random_vertices(plc, random, 60);
    check_that_nothing_is_given_up(mapped(plc, seed % 2 == 0 ? PointMap(turned_exactly) : PointMap(turned_to_utm)));
  }
}
