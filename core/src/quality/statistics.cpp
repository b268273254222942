// SPDX-License-Identifier: MIT
// Computes statistics of a whole mesh, declared in geomesh/core/quality.hpp.
#include <algorithm>
#include <numeric>
#include <optional>

#include "common/parallel.hpp"
#include "geomesh/core/quality.hpp"
#include "quality/causes.hpp"
#include "quality/edge_lengths.hpp"
#include "quality/shape_table.hpp"

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

/// Returns the rows of the tetrahedra of each group, in ascending order.
std::vector<std::vector<Index>> rows_by_group(std::span<const Index> group, std::size_t n_groups) {
  std::vector<std::size_t> count(n_groups, 0);
  for (const Index g : group) ++count[g];
  std::vector<std::vector<Index>> rows(n_groups);
  for (std::size_t g = 0; g < n_groups; ++g) rows[g].reserve(count[g]);
  for (std::size_t t = 0; t < group.size(); ++t) rows[group[t]].push_back(static_cast<Index>(t));
  return rows;
}

/// Tetrahedra of one group (for statistics) that are measured as one task.
struct Block {
  std::size_t group;
  std::span<const Index> rows;
};

std::vector<Block> blocks_of(const std::vector<std::vector<Index>>& rows) {
  constexpr std::size_t block_size = 65536;
  std::vector<Block> blocks;
  for (std::size_t g = 0; g < rows.size(); ++g)
    for (std::size_t begin = 0; begin < rows[g].size(); begin += block_size)
      blocks.push_back({g, std::span(rows[g]).subspan(begin, std::min(block_size, rows[g].size() - begin))});
  return blocks;
}

/// Returns the shape statistics of the whole mesh, followed by those of each group.
std::vector<ShapeStatistics> summarize_shapes(ShapeTable& table, const CellParts& parts, unsigned threads) {
  std::vector<std::vector<Index>> rows = rows_by_group(parts.group, parts.n_groups);
  const std::vector<Block> blocks = blocks_of(rows);
  std::vector<ShapeSums> of_block(blocks.size());
  for_each_task(blocks.size(), threads, [&](std::size_t k) { table.measure(blocks[k].rows, of_block[k]); });
  std::vector<ShapeSums> sums(1 + rows.size());
  for (std::size_t k = 0; k < blocks.size(); ++k)
    for (const std::size_t part : {std::size_t{0}, 1 + blocks[k].group}) sums[part].join(of_block[k]);
  std::vector<ShapeStatistics> out;
  for (const ShapeSums& s : sums) out.push_back(s.statistics());
  std::vector<Index> all(parts.group.size());
  std::iota(all.begin(), all.end(), Index{0});
  for_each_task(out.size() * n_shape_measures, threads, [&](std::size_t k) {
    const std::size_t part = k / n_shape_measures;
    const auto which = static_cast<ShapeMeasure>(k % n_shape_measures);
    const std::span<const Index> of_part = part == 0 ? all : rows[part - 1];
    if (!of_part.empty()) result_of(out[part], which).first_percentile = table.first_percentile(which, of_part);
  });
  return out;
}

/// Returns the statistics of the whole mesh, followed by those of each group. Edges are measured first, so that their
/// tables are freed before the tables of shapes are allocated.
std::vector<ShapeStatistics> summarize_all(std::optional<ShapeTable>& table, std::span<const Vec3> points,
                                           std::span<const Tetrahedron> tetrahedra, const CellParts& parts,
                                           const SizeField* size, unsigned threads) {
  std::vector<EdgeLengths> edges = measure_edges(points, tetrahedra, parts, size, threads);
  std::vector<Distribution> edge_length(edges.size());
  for_each_task(edges.size(), threads, [&](std::size_t k) {
    edge_length[k] = distribution(edges[k].length);
    edges[k].length = {};
  });
  table.emplace(points, tetrahedra);
  std::vector<ShapeStatistics> out = summarize_shapes(*table, parts, threads);
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k].edge_length = edge_length[k];
    out[k].edge_size_histogram = edges[k].by_size;
  }
  return out;
}

}  // namespace

double ShapeStatistics::share_within_size() const {
  const auto n =
      static_cast<double>(std::accumulate(edge_size_histogram.begin(), edge_size_histogram.end(), std::size_t{0}));
  const auto n_within = static_cast<double>(
      std::accumulate(edge_size_histogram.begin() + 2, edge_size_histogram.begin() + 6, std::size_t{0}));
  return n == 0 ? 1 : n_within / n;
}

ShapeStatistics measure_shapes(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra) {
  const unsigned threads = thread_count(0);
  const std::vector<Index> component(tetrahedra.size(), no_index), group(tetrahedra.size(), 0);
  std::optional<ShapeTable> table;
  return summarize_all(table, points, tetrahedra, {component, group, 1}, nullptr, threads).front();
}

namespace {

/// Returns the elements below the bad angle, and in any case the worst `min_worst` elements; the worst first.
std::vector<WorstElement> worst_elements(const ConstrainedTetrahedralization& mesh, const QualityOptions& options,
                                         const ShapeTable& shapes) {
  std::vector<WorstElement> worst;
  for (const auto& [angle, row] : shapes.with_least_angles(options.bad_angle, options.min_worst)) {
    const Tetrahedron& v = mesh.tetrahedra[row];
    WorstElement w;
    w.tetrahedron = row;
    w.min_dihedral = angle;
    w.max_dihedral = shapes.shape(row).max_dihedral;
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
  std::optional<ShapeTable> shapes;
  const CellParts parts = options.group.empty() ? CellParts{mesh.component, mesh.component, mesh.n_components}
                                                : CellParts{mesh.component, options.group, options.n_groups};
  q.per_component = summarize_all(shapes, mesh.points, mesh.tetrahedra, parts, options.size, threads);
  q.whole = q.per_component.front();
  q.per_component.erase(q.per_component.begin());

  q.worst = worst_elements(mesh, options, *shapes);
  if (q.worst.empty()) return q;
  const InputCreases creases = find_creases(plc, options);
  CauseFinder causes(mesh, options, creases);
  for (WorstElement& w : q.worst) {
    causes.explain(w);
    q.n_bad += w.min_dihedral < options.bad_angle;
    q.n_bad_forced += w.min_dihedral < options.bad_angle && w.cause != ShapeCause::free;
  }
  // Elements that the input does not impose are those that a user should look at. They come first in the list, followed
  // by the other elements; both are sorted with the worst first.
  std::stable_partition(q.worst.begin(), q.worst.end(),
                        [](const WorstElement& w) { return w.cause == ShapeCause::free; });
  if (q.worst.size() > options.max_worst) q.worst.resize(options.max_worst);
  return q;
}

}  // namespace geomesh
