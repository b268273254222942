// SPDX-License-Identifier: MIT
// Every quality measure against closed forms, differences and random cells.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "geomesh/core/predicates.hpp"
#include "geomesh/core/quality.hpp"
#include "quality/measure/cell_quality.hpp"
#include "quality_measures.hpp"

using namespace geomesh;
using namespace geomesh::remesh;
using geomesh::test::all_measures;

namespace {

using Cell = std::array<Vec3, 4>;

const Cell regular{Vec3{1, 1, 1}, Vec3{1, -1, -1}, Vec3{-1, -1, 1}, Vec3{-1, 1, -1}};

/// Positive, from nearly regular to nearly flat.
class RandomCells {
 public:
  explicit RandomCells(unsigned seed) : random_(seed) {}
  Cell next() {
    const double spread = std::pow(10.0, -2 * share_(random_));
    Cell p;
    for (Vec3& q : p) q = {unit_(random_), unit_(random_), spread * unit_(random_)};
    if (orient3d(p[0], p[1], p[2], p[3]) != Sign::positive) std::swap(p[0], p[1]);
    return p;
  }

 private:
  std::mt19937 random_;
  std::uniform_real_distribution<double> unit_{-1, 1}, share_{0, 1};
};

double shape_of(const CellQuality& q, const Cell& p) { return q.shape(p[0], p[1], p[2], p[3]); }

/// The measure by angles, radii and lengths.
double expected(QualityMeasure measure, const TetrahedronShape& s) {
  if (measure == QualityMeasure::radius_ratio) return s.radius_ratio;
  if (measure == QualityMeasure::mean_ratio) return std::pow(s.mean_ratio, 1.5);
  double least = 1;
  for (const double a : s.dihedral)
    least = std::min(least, std::sin(a * std::numbers::pi / 180) * (a > 90 ? DihedralMeasure::obtuse_weight : 1));
  return least;
}

}  // namespace

TEST_CASE("Each quality measure is what angles, radii and edges of a cell say", "[quality]") {
  for (const QualityMeasure measure : all_measures) {
    const CellQuality quality(measure);
    CAPTURE(name_of(measure));
    RandomCells cells(7);
    for (int trial = 0; trial < 500; ++trial) {
      const Cell p = cells.next();
      const double s = shape_of(quality, p);
      CHECK(s == Approx(expected(measure, tetrahedron_shape(p[0], p[1], p[2], p[3]))).margin(1e-9));
      CHECK(s <= quality.largest());
      CHECK(quality.shape(p[1], p[0], p[2], p[3]) < 0);  // inverted
    }
    CHECK(shape_of(quality, regular) <= quality.largest());
    CHECK(shape_of(quality, regular) == Approx(quality.largest()).epsilon(1e-5));
    CHECK(quality_measure_of(name_of(measure)) == measure);
  }
  CHECK_FALSE(quality_measure_of("roundness"));
}

TEST_CASE("The gradients of each quality measure are those of small differences", "[quality]") {
  for (const QualityMeasure measure : all_measures) {
    const CellQuality quality(measure);
    CAPTURE(name_of(measure));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> u(-0.4, 0.4);
    for (int trial = 0; trial < 200; ++trial) {
      Cell p = regular;
      for (Vec3& q : p) q = q + Vec3{u(random), u(random), u(random)};
      const double s = shape_of(quality, p);
      std::vector<Vec3> all, least;
      quality.append_gradients({p[0], p[1], p[2]}, p[3], 2, all);
      quality.append_gradients({p[0], p[1], p[2]}, p[3], s * (1 + 1e-12), least);
      CHECK(all.size() == (measure == QualityMeasure::dihedral ? 6 : 1));
      REQUIRE(least.size() == 1);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        constexpr double h = 1e-6;
        Cell forward = p, back = p;
        forward[3][axis] += h;
        back[3][axis] -= h;
        const double f = shape_of(quality, forward), b = shape_of(quality, back);
        if (std::abs(f - b) < 1e-5)  // not across the step of the weight at 90 degrees
          CHECK(least[0][axis] == Approx((f - b) / (2 * h)).margin(1e-5));
      }
    }
  }
}

TEST_CASE("Where two cells share an angle of one, the bound for half of it holds for the worse of them", "[quality]") {
  for (const QualityMeasure measure : all_measures) {
    const CellQuality quality(measure);
    CAPTURE(name_of(measure));
    RandomCells cells(11);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> u(0.05, 0.95), far(0.2, 3);
    double nearest = 1;
    for (int trial = 0; trial < 4000; ++trial) {
      const Cell p = cells.next();  // the angle at the edge (p[2], p[3]) is shared by a vertex between p[0] and p[1]
      const Vec3 middle = 0.5 * (p[2] + p[3]), between = p[0] + u(random) * (p[1] - p[0]);
      const Vec3 v = middle + far(random) * (between - middle);
      const double one = quality.shape(p[0], v, p[2], p[3]), other = quality.shape(v, p[1], p[2], p[3]);
      const double most = quality.most_of_half_angle(p[0], p[1], p[2], p[3]);
      CHECK(std::min(one, other) <= most);
      CHECK(quality.worth(one) + quality.worth(other) <= 2 * most);
      nearest = std::min(nearest, most / std::max(std::min(one, other), 1e-3));
    }
    CHECK(nearest < 1.2);  // it says something
  }
}

TEST_CASE("Limits given as angles rise with the angle and mean the same sliver to every measure", "[quality]") {
  for (const QualityMeasure measure : all_measures) {
    const CellQuality quality(measure);
    CAPTURE(name_of(measure));
    for (double degrees = 1; degrees < 70; ++degrees) {
      CHECK(quality.of_angle(degrees) < quality.of_angle(degrees + 1));
      CHECK(quality.of_angle(degrees) == Approx(std::sin(degrees * std::numbers::pi / 180)).epsilon(0.12));
    }
    const double poor = quality.of_angle(12);
    CHECK(quality.worth(1.01 * poor) == 1.01 * poor);
    CHECK(quality.worth(0.9 * poor) == Approx(0.7 * poor).epsilon(1e-3));
    CHECK(quality.bad() == quality.of_angle(8));
  }
}

TEST_CASE("The range of dihedral angles is that of all six", "[quality]") {
  RandomCells cells(7);
  const auto agrees = [](const Cell& p) {
    const TetrahedronShape all = tetrahedron_shape(p[0], p[1], p[2], p[3]);
    const DihedralRange range = dihedral_range(p[0], p[1], p[2], p[3]);
    return range.least == all.min_dihedral && range.greatest == all.max_dihedral;
  };
  CHECK(agrees(regular));
  std::size_t n_wrong = 0;
  for (int k = 0; k < 20000; ++k) {
    Cell p = cells.next();
    n_wrong += !agrees(p);
    if (k % 10 == 0) std::swap(p[0], p[1]), n_wrong += !agrees(p);  // inverted
  }
  CHECK(n_wrong == 0);
  CHECK(agrees({Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{1, 1, 0}}));  // flat
}
