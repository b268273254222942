// SPDX-License-Identifier: MIT
// Percentiles and lists of the worst beside sorted values of all tetrahedra.
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "geomesh/core/predicates.hpp"
#include "quality/shape_table.hpp"

using namespace geomesh;

namespace {

struct Soup {
  std::vector<Vec3> points;
  std::vector<Tetrahedron> tetrahedra;
};

/// Of no mesh: tetrahedra apart from each other, one in ten of them nearly flat.
Soup random_soup(std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  Soup soup;
  for (std::size_t t = 0; t < n; ++t) {
    const double height = t % 10 == 0 ? 1e-3 : 1;
    Tetrahedron v;
    for (VertexIndex& k : v) {
      k = static_cast<VertexIndex>(soup.points.size());
      soup.points.push_back({unit(random), unit(random), height * unit(random)});
    }
    const std::vector<Vec3>& p = soup.points;
    if (orient3d(p[v[0]], p[v[1]], p[v[2]], p[v[3]]) != Sign::positive) std::swap(v[0], v[1]);
    soup.tetrahedra.push_back(v);
  }
  return soup;
}

std::vector<double> values_of(const ShapeTable& table, std::span<const Index> rows, ShapeMeasure which) {
  std::vector<double> values;
  for (const Index row : rows) {
    const TetrahedronShape s = table.shape(row);
    switch (which) {
      case ShapeMeasure::min_dihedral:
        values.push_back(s.min_dihedral);
        break;
      case ShapeMeasure::max_dihedral:
        values.push_back(s.max_dihedral);
        break;
      case ShapeMeasure::radius_ratio:
        values.push_back(s.radius_ratio);
        break;
      case ShapeMeasure::aspect:
        values.push_back(s.aspect);
        break;
      case ShapeMeasure::mean_ratio:
        values.push_back(s.mean_ratio);
        break;
      case ShapeMeasure::solid_angle:
        values.insert(values.end(), s.solid_angle.begin(), s.solid_angle.end());
    }
  }
  std::sort(values.begin(), values.end());
  return values;
}

}  // namespace

TEST_CASE("Percentiles and extremes from steps are those of the sorted values", "[quality]") {
  for (const std::size_t n : {std::size_t{1}, std::size_t{99}, std::size_t{1000}, std::size_t{80000}}) {
    const Soup soup = random_soup(n, static_cast<unsigned>(n));
    ShapeTable table(soup.points, soup.tetrahedra);
    std::vector<Index> rows;
    for (std::size_t t = 0; t<n; t += n> 1000 ? 1 : 2) rows.push_back(static_cast<Index>(t));
    ShapeSums first, second;
    const auto half = rows.size() / 2;
    table.measure(std::span(rows).first(half), first);
    table.measure(std::span(rows).subspan(half), second);
    first.join(second);
    ShapeStatistics statistics = first.statistics();
    CHECK(statistics.n_tetrahedra == rows.size());
    for (std::size_t m = 0; m < n_shape_measures; ++m) {
      const auto which = static_cast<ShapeMeasure>(m);
      const std::vector<double> values = values_of(table, rows, which);
      const Distribution& d = result_of(statistics, which);
      CHECK(table.first_percentile(which, rows) == values[values.size() / 100]);
      CHECK(d.min == values.front());
      CHECK(d.max == values.back());
      double sum = 0;
      for (const double v : values) sum += v;
      CHECK(d.mean == Approx(sum / static_cast<double>(values.size())));
    }
  }
}

TEST_CASE("The tetrahedra with the least angles come in order, and as many as are asked for", "[quality]") {
  const Soup soup = random_soup(5000, 3);
  ShapeTable table(soup.points, soup.tetrahedra);
  std::vector<std::pair<double, Index>> all;
  std::vector<Index> rows;
  for (Index t = 0; t < soup.tetrahedra.size(); ++t) {
    rows.push_back(t);
    all.emplace_back(table.shape(t).min_dihedral, t);
  }
  ShapeSums sums;
  table.measure(rows, sums);
  std::sort(all.begin(), all.end());
  for (const double angle : {0.0, 0.01, 1.0, 20.0, 200.0})
    for (const std::size_t least : {std::size_t{0}, std::size_t{1}, std::size_t{700}, std::size_t{9999}}) {
      const auto n_below = static_cast<std::size_t>(
          std::count_if(all.begin(), all.end(), [&](const auto& a) { return a.first < angle; }));
      const std::size_t n = std::max(n_below, std::min(least, all.size()));
      const auto found = table.with_least_angles(angle, least);
      CHECK(std::equal(found.begin(), found.end(), all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n)));
    }
}
