// SPDX-License-Identifier: MIT
// The loops over a link against its cells one by one, for every measure.
#include <catch2/catch.hpp>
#include <random>

#include "quality/measure/cell_quality.hpp"
#include "quality/measure/link_shapes.hpp"
#include "quality_measures.hpp"

using namespace geomesh;
using namespace geomesh::remesh;
using geomesh::test::all_measures;

namespace {

using Face = std::array<Vec3, 3>;

/// n faces seen from about the origin, of all shapes.
std::vector<Face> random_link(std::size_t n, unsigned seed) {
  const CellQuality quality;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto point = [&] { return Vec3{coordinate(random), coordinate(random), coordinate(random)}; };
  std::vector<Face> faces;
  while (faces.size() < n) {
    Face f{point(), point(), point()};
    if (quality.shape(f[0], f[1], f[2], {}) <= 0) std::swap(f[0], f[1]);
    if (quality.shape(f[0], f[1], f[2], {}) > 0.02) faces.push_back(f);
  }
  return faces;
}

LinkShapes link_of(const std::vector<Face>& faces, QualityMeasure measure) {
  LinkShapes link;
  link.clear(link_kernels(measure));
  for (const Face& f : faces) link.add(f[0], f[1], f[2]);
  link.prepare();
  return link;
}

}  // namespace

TEST_CASE("Shapes over a link are, bit by bit, those of its cells one by one", "[quality]") {
  for (const QualityMeasure measure : all_measures)
    for (std::size_t n = 1; n <= 40; ++n) {
      const CellQuality quality(measure);
      const std::vector<Face> faces = random_link(n, static_cast<unsigned>(n));
      const LinkShapes link = link_of(faces, measure);
      REQUIRE(link.size() == n);
      for (const Vec3& p : {Vec3{}, Vec3{0.02, -0.01, 0.03}, Vec3{0.5, 0.6, -0.2}}) {
        double least = 1, sum = 0;
        for (std::size_t k = 0; k < n; ++k) {
          const double s = quality.shape(faces[k][0], faces[k][1], faces[k][2], p);
          CHECK(link.shapes(p)[k] == s);
          least = std::min(least, s);
          sum += quality.worth(s);
        }
        CHECK(link.worst(p, -100) == least);
        CHECK(link.worst(p, 0.5) <= std::max(0.5, least));
        CHECK(link.sum_of_worths(p, least + 1e-9) < -1e300);
        if (least > 0) CHECK(link.sum_of_worths(p, 0) == Approx(sum).epsilon(1e-12));
      }
    }
}

TEST_CASE("The gradient of the sum over a link is that of small differences", "[quality]") {
  for (const QualityMeasure measure : all_measures)
    for (unsigned seed = 1; seed <= 50; ++seed) {
      const LinkShapes link = link_of(random_link(1 + seed % 9, 100 + seed), measure);
      const Vec3 g = link.gradient_of_sum({});
      for (unsigned axis = 0; axis < 3; ++axis) {
        Vec3 step;
        step[axis] = 1e-7;
        const double slope = (link.sum_of_worths(step, 0) - link.sum_of_worths(-1.0 * step, 0)) / 2e-7;
        CHECK(g[axis] == Approx(slope).epsilon(1e-4).margin(1e-4));
      }
    }
}

TEST_CASE("All kernels over links give the same bits", "[quality]") {
#if defined(__x86_64__)
  if (!__builtin_cpu_supports("avx2")) WARN("this processor has no AVX2: one kernel only");
  for (const QualityMeasure measure : all_measures)
    for (unsigned seed = 1; seed <= 50; ++seed) {
      std::vector<FourFaces> one(3), two;
      const std::vector<Face> faces = random_link(12, 500 + seed);
      for (std::size_t k = 0; k < 12; ++k)
        for (unsigned i = 0; i < 3; ++i)
          for (unsigned axis = 0; axis < 3; ++axis)
            one[k / 4].corner[i][axis][k % 4] = faces[k][i][axis], one[k / 4].share[k % 4] = 1;
      two = one;
      const LinkKernels &base = remesh::detail::baseline_link_kernels[static_cast<std::size_t>(measure)],
                        &other = link_kernels(measure);
      base.prepare(one.data(), 3);
      other.prepare(two.data(), 3);
      const Vec3 p{0.01, 0.02, -0.01};
      std::array<double, 12> s, t;
      base.shapes(one.data(), 3, p, s.data());
      other.shapes(two.data(), 3, p, t.data());
      CHECK(s == t);
      CHECK(base.worst(one.data(), 3, p, 0.3) == other.worst(two.data(), 3, p, 0.3));
      CHECK(base.sum_of_worths(one.data(), 3, {}, 0) == other.sum_of_worths(two.data(), 3, {}, 0));
      CHECK(base.gradient_of_sum(one.data(), 3, {}) == other.gradient_of_sum(two.data(), 3, {}));
    }
#else
  WARN("one kernel only");
#endif
}
