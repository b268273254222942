// SPDX-License-Identifier: MIT
// Statistics of a whole mesh, declared in geomesh/core/quality.hpp.
#include <algorithm>
#include <numeric>

#include "common/parallel.hpp"
#include "geomesh/core/quality.hpp"
#include "quality/causes.hpp"
#include "quality/edge_lengths.hpp"

namespace geomesh {

namespace {

Distribution distribution(std::vector<double>& values) {
  Distribution d;
  if (values.empty()) return d;
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  d.min = *least;
  d.max = *greatest;
  for (const double v : values) d.mean += v;
  d.mean /= static_cast<double>(values.size());
  const auto first = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 100);
  std::nth_element(values.begin(), first, values.end());
  d.first_percentile = *first;
  return d;
}

/// Of N equal ones from 0 to `top`.
template <std::size_t N>
std::size_t bin_of(double value, double top) {
  const double bin = value / top * static_cast<double>(N);
  return static_cast<std::size_t>(std::clamp(bin, 0.0, static_cast<double>(N) - 1));
}

/// Shapes of all tetrahedra, an array for each measure.
struct ShapeTable {
  explicit ShapeTable(std::size_t n)
      : min_dihedral(n),
        max_dihedral(n),
        radius_ratio(n),
        aspect(n),
        mean_ratio(n),
        volume(n),
        solid_angle(n),
        dihedral_bin(n) {}

  std::vector<double> min_dihedral, max_dihedral, radius_ratio, aspect, mean_ratio, volume;
  std::vector<std::array<double, 4>> solid_angle;
  std::vector<std::array<std::uint8_t, 6>> dihedral_bin;
};

ShapeTable measure_all(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra, unsigned threads) {
  ShapeTable table(tetrahedra.size());
  for_each_index(tetrahedra.size(), threads, [&](std::size_t i) {
    const Tetrahedron& t = tetrahedra[i];
    const TetrahedronShape s = tetrahedron_shape(points[t[0]], points[t[1]], points[t[2]], points[t[3]]);
    table.min_dihedral[i] = s.min_dihedral;
    table.max_dihedral[i] = s.max_dihedral;
    table.radius_ratio[i] = s.radius_ratio;
    table.aspect[i] = s.aspect;
    table.mean_ratio[i] = s.mean_ratio;
    table.volume[i] = s.volume;
    table.solid_angle[i] = s.solid_angle;
    for (unsigned e = 0; e < 6; ++e)
      table.dihedral_bin[i][e] = static_cast<std::uint8_t>(bin_of<36>(s.dihedral[e], 180));
  });
  return table;
}

/// Counts and sums of the tetrahedra in `rows`.
ShapeStatistics count_shapes(const ShapeTable& table, std::span<const Index> rows) {
  ShapeStatistics out;
  if (rows.empty()) return out;
  out.n_tetrahedra = rows.size();
  std::size_t below_10 = 0, above_24_85 = 0;
  for (const Index t : rows) {
    out.volume += table.volume[t];
    for (const std::uint8_t bin : table.dihedral_bin[t]) ++out.dihedral_histogram[bin];
    ++out.min_dihedral_histogram[bin_of<18>(table.min_dihedral[t], 90)];
    ++out.radius_ratio_histogram[bin_of<20>(table.radius_ratio[t], 1)];
    below_10 += table.min_dihedral[t] < 10;
    above_24_85 += table.min_dihedral[t] > 24.85;
  }
  out.share_below_10 = static_cast<double>(below_10) / static_cast<double>(rows.size());
  out.share_above_24_85 = static_cast<double>(above_24_85) / static_cast<double>(rows.size());
  return out;
}

/// A distribution of the statistics, with the values that it is of: one of five, or solid angles.
struct Measure {
  Distribution ShapeStatistics::*result;
  std::vector<double> ShapeTable::*values;
};
constexpr std::array<Measure, 5> measures{{{&ShapeStatistics::min_dihedral, &ShapeTable::min_dihedral},
                                           {&ShapeStatistics::max_dihedral, &ShapeTable::max_dihedral},
                                           {&ShapeStatistics::radius_ratio, &ShapeTable::radius_ratio},
                                           {&ShapeStatistics::aspect, &ShapeTable::aspect},
                                           {&ShapeStatistics::mean_ratio, &ShapeTable::mean_ratio}}};

Distribution distribution_of(const std::vector<double>& measure, std::span<const Index> rows) {
  std::vector<double> values;
  values.reserve(rows.size());
  for (const Index t : rows) values.push_back(measure[t]);
  return distribution(values);
}

Distribution solid_angles(const ShapeTable& table, std::span<const Index> rows) {
  std::vector<double> values;
  values.reserve(4 * rows.size());
  for (const Index t : rows) values.insert(values.end(), table.solid_angle[t].begin(), table.solid_angle[t].end());
  return distribution(values);
}

/// Rows of tetrahedra by group, each in ascending order; the first list is that of all.
std::vector<std::vector<Index>> rows_by_group(std::span<const Index> group, std::size_t n_groups) {
  std::vector<std::vector<Index>> rows(1 + n_groups);
  for (std::size_t t = 0; t < group.size(); ++t)
    for (const std::size_t k : {std::size_t{0}, std::size_t{1} + group[t]}) rows[k].push_back(static_cast<Index>(t));
  return rows;
}

/// Of the whole, then of each group: one task a group and kind of statistics, the largest first.
std::vector<ShapeStatistics> summarize_shapes(const ShapeTable& table, const CellParts& parts, unsigned threads) {
  const std::vector<std::vector<Index>> rows = rows_by_group(parts.group, parts.n_groups);
  const std::size_t n = rows.size();
  std::vector<ShapeStatistics> out(n);
  for_each_task(n, threads, [&](std::size_t k) { out[k] = count_shapes(table, rows[k]); });
  for_each_task(n, threads, [&](std::size_t k) { out[k].solid_angle = solid_angles(table, rows[k]); });
  for_each_task(n * measures.size(), threads, [&](std::size_t k) {
    const auto& [result, values] = measures[k % measures.size()];
    out[k / measures.size()].*result = distribution_of(table.*values, rows[k / measures.size()]);
  });
  return out;
}

/// Of the whole, then of each group. Edges come first: their tables are gone when those of shapes are made.
std::vector<ShapeStatistics> summarize_all(ShapeTable& table, std::span<const Vec3> points,
                                           std::span<const Tetrahedron> tetrahedra, const CellParts& parts,
                                           const SizeField* size, unsigned threads) {
  std::vector<EdgeLengths> edges = measure_edges(points, tetrahedra, parts, size, threads);
  std::vector<Distribution> edge_length(edges.size());
  for_each_task(edges.size(), threads, [&](std::size_t k) {
    edge_length[k] = distribution(edges[k].length);
    edges[k].length = {};
  });
  table = measure_all(points, tetrahedra, threads);
  std::vector<ShapeStatistics> out = summarize_shapes(table, parts, threads);
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k].edge_length = edge_length[k];
    out[k].edge_size_histogram = edges[k].by_size;
  }
  return out;
}

}  // namespace

ShapeStatistics measure_shapes(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra) {
  const unsigned threads = thread_count(0);
  const std::vector<Index> component(tetrahedra.size(), no_index), group(tetrahedra.size(), 0);
  ShapeTable table(0);
  return summarize_all(table, points, tetrahedra, {component, group, 1}, nullptr, threads).front();
}

namespace {

/// Elements below the bad angle, and the worst whatever they are up to the number that is to be listed; the worst
/// first.
std::vector<WorstElement> worst_elements(const ConstrainedTetrahedralization& mesh, const QualityOptions& options,
                                         const ShapeTable& shapes) {
  const std::vector<double>& least = shapes.min_dihedral;
  std::vector<Index> order(least.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto first_good =
      std::partition(order.begin(), order.end(), [&](Index t) { return least[t] < options.bad_angle; });
  const auto worse = [&](Index a, Index b) { return least[a] != least[b] ? least[a] < least[b] : a < b; };
  const auto n_bad = static_cast<std::size_t>(first_good - order.begin());
  const std::size_t n = std::max(n_bad, std::min(options.min_worst, order.size()));
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(n), order.end(), worse);
  std::vector<WorstElement> worst;
  for (std::size_t i = 0; i < n; ++i) {
    const Tetrahedron& v = mesh.tetrahedra[order[i]];
    WorstElement w;
    w.tetrahedron = order[i];
    w.min_dihedral = least[order[i]];
    w.max_dihedral = shapes.max_dihedral[order[i]];
    w.place = 0.25 * (mesh.points[v[0]] + mesh.points[v[1]] + mesh.points[v[2]] + mesh.points[v[3]]);
    worst.push_back(w);
  }
  return worst;
}

}  // namespace

MeshQuality measure_quality(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                            const QualityOptions& options) {
  MeshQuality q;
  const unsigned threads = thread_count(options.threads);
  ShapeTable shapes(0);
  const CellParts parts = options.group.empty() ? CellParts{mesh.component, mesh.component, mesh.n_components}
                                                : CellParts{mesh.component, options.group, options.n_groups};
  q.per_component = summarize_all(shapes, mesh.points, mesh.tetrahedra, parts, options.size, threads);
  q.whole = q.per_component.front();
  q.per_component.erase(q.per_component.begin());

  q.worst = worst_elements(mesh, options, shapes);
  if (q.worst.empty()) return q;
  const InputCreases creases = find_creases(plc, options);
  CauseFinder causes(mesh, options, creases);
  for (WorstElement& w : q.worst) {
    causes.explain(w);
    q.n_bad += w.min_dihedral < options.bad_angle;
    q.n_bad_forced += w.min_dihedral < options.bad_angle && w.cause != ShapeCause::free;
  }
  // Those that nothing forces are what a user should look at: they lead the list, each kind the worst first.
  std::stable_partition(q.worst.begin(), q.worst.end(),
                        [](const WorstElement& w) { return w.cause == ShapeCause::free; });
  if (q.worst.size() > options.max_worst) q.worst.resize(options.max_worst);
  return q;
}

}  // namespace geomesh
