// SPDX-License-Identifier: MIT
#include "quality/shape_table.hpp"

#include <algorithm>
#include <limits>

namespace geomesh {

namespace {

constexpr std::size_t n_steps = 65536;
/// The greatest possible value of each measure. Larger ones, by rounding, are counted in the last bin of its histogram.
constexpr std::array<double, n_shape_measures> top{180, 180, 1, 1, 1, 360};

/// Returns the bin that contains a value, among N equal bins from 0 to `greatest`.
template <std::size_t N>
std::size_t bin_of(double value, double greatest) {
  const double bin = value / greatest * static_cast<double>(N);
  return static_cast<std::size_t>(std::clamp(bin, 0.0, static_cast<double>(N) - 1));
}

constexpr std::size_t index_of(ShapeMeasure m) { return static_cast<std::size_t>(m); }

/// The member of ShapeStatistics that contains the result of each measure.
constexpr std::array<Distribution ShapeStatistics::*, n_shape_measures> results{
    &ShapeStatistics::min_dihedral, &ShapeStatistics::max_dihedral, &ShapeStatistics::radius_ratio,
    &ShapeStatistics::aspect,       &ShapeStatistics::mean_ratio,   &ShapeStatistics::solid_angle};

double value_of(const TetrahedronShape& s, ShapeMeasure which, std::size_t corner) {
  switch (which) {
    case ShapeMeasure::min_dihedral:
      return s.min_dihedral;
    case ShapeMeasure::max_dihedral:
      return s.max_dihedral;
    case ShapeMeasure::radius_ratio:
      return s.radius_ratio;
    case ShapeMeasure::aspect:
      return s.aspect;
    case ShapeMeasure::mean_ratio:
      return s.mean_ratio;
    case ShapeMeasure::solid_angle:
      break;
  }
  return s.solid_angle[corner];
}

/// Calls visit(measure, corner, value) for all measured values of a tetrahedron; four of them are solid angles.
template <class Visit>
void for_each_value(const TetrahedronShape& s, const Visit& visit) {
  for (std::size_t m = 0; m < n_shape_measures; ++m) {
    const auto which = static_cast<ShapeMeasure>(m);
    const std::size_t n = which == ShapeMeasure::solid_angle ? 4 : 1;
    for (std::size_t corner = 0; corner < n; ++corner) visit(m, corner, value_of(s, which, corner));
  }
}

}  // namespace

Distribution& result_of(ShapeStatistics& statistics, ShapeMeasure which) {
  return statistics.*results[index_of(which)];
}

ShapeSums::ShapeSums() {
  least.fill(std::numeric_limits<double>::infinity());
  greatest.fill(-std::numeric_limits<double>::infinity());
}

void ShapeSums::add(const TetrahedronShape& s) {
  ++counts.n_tetrahedra;
  counts.volume += s.volume;
  for (const double angle : s.dihedral) ++counts.dihedral_histogram[bin_of<36>(angle, 180)];
  ++counts.min_dihedral_histogram[bin_of<18>(s.min_dihedral, 90)];
  ++counts.radius_ratio_histogram[bin_of<20>(s.radius_ratio, 1)];
  n_below_10 += s.min_dihedral < 10;
  n_above_24_85 += s.min_dihedral > 24.85;
  for_each_value(s, [&](std::size_t m, std::size_t, double value) {
    sum[m] += value;
    least[m] = std::min(least[m], value);
    greatest[m] = std::max(greatest[m], value);
  });
}

void ShapeSums::join(const ShapeSums& o) {
  const auto add_counts = [](auto& mine, const auto& others) {
    for (std::size_t k = 0; k < mine.size(); ++k) mine[k] += others[k];
  };
  counts.n_tetrahedra += o.counts.n_tetrahedra;
  counts.volume += o.counts.volume;
  add_counts(counts.dihedral_histogram, o.counts.dihedral_histogram);
  add_counts(counts.min_dihedral_histogram, o.counts.min_dihedral_histogram);
  add_counts(counts.radius_ratio_histogram, o.counts.radius_ratio_histogram);
  n_below_10 += o.n_below_10;
  n_above_24_85 += o.n_above_24_85;
  add_counts(sum, o.sum);
  for (std::size_t m = 0; m < n_shape_measures; ++m) {
    least[m] = std::min(least[m], o.least[m]);
    greatest[m] = std::max(greatest[m], o.greatest[m]);
  }
}

ShapeStatistics ShapeSums::statistics() const {
  ShapeStatistics out = counts;
  if (counts.n_tetrahedra == 0) return out;
  const auto n = static_cast<double>(counts.n_tetrahedra);
  out.share_below_10 = static_cast<double>(n_below_10) / n;
  out.share_above_24_85 = static_cast<double>(n_above_24_85) / n;
  for (std::size_t m = 0; m < n_shape_measures; ++m) {
    Distribution& d = result_of(out, static_cast<ShapeMeasure>(m));
    d.min = least[m];
    d.max = greatest[m];
    d.mean = sum[m] / (static_cast<ShapeMeasure>(m) == ShapeMeasure::solid_angle ? 4 * n : n);
  }
  return out;
}

ShapeTable::ShapeTable(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra)
    : points_(points), tetrahedra_(tetrahedra) {
  for (std::size_t m = 0; m < n_shape_measures; ++m)
    steps_[m].resize(values_a_row(static_cast<ShapeMeasure>(m)) * tetrahedra.size());
}

TetrahedronShape ShapeTable::shape(Index row) const {
  const Tetrahedron& t = tetrahedra_[row];
  return tetrahedron_shape(points_[t[0]], points_[t[1]], points_[t[2]], points_[t[3]]);
}

void ShapeTable::measure(std::span<const Index> rows, ShapeSums& sums) {
  for (const Index row : rows) {
    const TetrahedronShape s = shape(row);
    sums.add(s);
    for_each_value(s, [&](std::size_t m, std::size_t corner, double value) {
      steps_[m][values_a_row(static_cast<ShapeMeasure>(m)) * row + corner] =
          static_cast<Step>(bin_of<n_steps>(value, top[m]));
    });
  }
}

std::pair<ShapeTable::Step, std::size_t> ShapeTable::step_at(std::size_t rank, ShapeMeasure which,
                                                             std::span<const Index> rows) const {
  const std::vector<Step>& steps = steps_[index_of(which)];
  const std::size_t n_values = values_a_row(which);
  if (rows.size() < n_steps) {
    std::vector<Step> some;
    some.reserve(n_values * rows.size());
    for (const Index row : rows)
      some.insert(some.end(), steps.begin() + static_cast<std::ptrdiff_t>(n_values * row),
                  steps.begin() + static_cast<std::ptrdiff_t>(n_values * (row + 1)));
    const auto at = some.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(some.begin(), at, some.end());
    return {*at, static_cast<std::size_t>(std::count_if(some.begin(), at, [&](Step s) { return s < *at; }))};
  }
  std::vector<std::size_t> count(n_steps, 0);
  for (const Index row : rows)
    for (std::size_t k = n_values * row; k < n_values * (row + 1); ++k) ++count[steps[k]];
  std::size_t step = 0, below = 0;
  while (below + count[step] <= rank) below += count[step++];
  return {static_cast<Step>(step), below};
}

double ShapeTable::first_percentile(ShapeMeasure which, std::span<const Index> rows) const {
  const std::size_t n_values = values_a_row(which), rank = n_values * rows.size() / 100;
  const auto [step, below] = step_at(rank, which, rows);
  const std::vector<Step>& steps = steps_[index_of(which)];
  std::vector<double> values;
  for (const Index row : rows)
    for (std::size_t corner = 0; corner < n_values; ++corner)
      if (steps[n_values * row + corner] == step) values.push_back(value_of(shape(row), which, corner));
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank - below);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

std::vector<std::pair<double, Index>> ShapeTable::with_least_angles(double angle, std::size_t n_least) const {
  const std::vector<Step>& steps = steps_[index_of(ShapeMeasure::min_dihedral)];
  std::size_t limit = bin_of<n_steps>(angle, top[0]);
  std::vector<std::size_t> count(n_steps, 0);
  for (const Step s : steps) ++count[s];
  std::size_t below = 0, step = 0;
  while (step < n_steps && below < n_least) below += count[step++];
  limit = std::max(limit, step);
  std::vector<std::pair<double, Index>> found;
  for (std::size_t row = 0; row < steps.size(); ++row)
    if (steps[row] <= limit) found.emplace_back(shape(static_cast<Index>(row)).min_dihedral, static_cast<Index>(row));
  std::sort(found.begin(), found.end());
  const auto first_good =
      std::partition_point(found.begin(), found.end(), [&](const auto& f) { return f.first < angle; });
  const auto n_bad = static_cast<std::size_t>(first_good - found.begin());
  found.resize(std::max(n_bad, std::min(n_least, found.size())));
  return found;
}

}  // namespace geomesh
