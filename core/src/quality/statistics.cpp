// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "geomesh/core/quality.hpp"
#include "geomesh/core/simplex_mesh.hpp"
#include "quality/causes.hpp"
#include "quality/shape.hpp"

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

template <std::size_t N>
void count(std::array<std::size_t, N>& histogram, double value, double top) {
  const double bin = value / top * static_cast<double>(N);
  ++histogram[static_cast<std::size_t>(std::clamp(bin, 0.0, static_cast<double>(N) - 1))];
}

struct SizedEdge {
  VertexIndex a, b;
  bool operator<(const SizedEdge& o) const { return std::pair(a, b) < std::pair(o.a, o.b); }
  bool operator==(const SizedEdge& o) const { return a == o.a && b == o.b; }
};

/// Gathers shapes one by one, then makes the statistics.
class Accumulator {
 public:
  void add(std::span<const Vec3> points, const Tetrahedron& t) {
    const TetrahedronShape s = tetrahedron_shape(points[t[0]], points[t[1]], points[t[2]], points[t[3]]);
    ++out_.n_tetrahedra;
    out_.volume += s.volume;
    for (const double a : s.dihedral) count(out_.dihedral_histogram, a, 180);
    count(out_.min_dihedral_histogram, s.min_dihedral, 90);
    count(out_.radius_ratio_histogram, s.radius_ratio, 1);
    below_10_ += s.min_dihedral < 10;
    above_ += s.min_dihedral > 24.85;
    min_dihedral_.push_back(s.min_dihedral);
    max_dihedral_.push_back(s.max_dihedral);
    solid_.insert(solid_.end(), s.solid_angle.begin(), s.solid_angle.end());
    radius_ratio_.push_back(s.radius_ratio);
    aspect_.push_back(s.aspect);
    mean_ratio_.push_back(s.mean_ratio);
    for (const auto& e : edge_vertices) edges_.push_back({std::min(t[e[0]], t[e[1]]), std::max(t[e[0]], t[e[1]])});
  }

  ShapeStatistics finish(std::span<const Vec3> points, const SizeField* size, Index component) {
    if (out_.n_tetrahedra > 0) {
      out_.share_below_10 = static_cast<double>(below_10_) / static_cast<double>(out_.n_tetrahedra);
      out_.share_above_24_85 = static_cast<double>(above_) / static_cast<double>(out_.n_tetrahedra);
    }
    out_.min_dihedral = distribution(min_dihedral_);
    out_.max_dihedral = distribution(max_dihedral_);
    out_.solid_angle = distribution(solid_);
    out_.radius_ratio = distribution(radius_ratio_);
    out_.aspect = distribution(aspect_);
    out_.mean_ratio = distribution(mean_ratio_);
    measure_edges(points, size, component);
    return out_;
  }

 private:
  void measure_edges(std::span<const Vec3> points, const SizeField* size, Index component) {
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    std::vector<double> lengths;
    lengths.reserve(edges_.size());
    for (const SizedEdge& e : edges_) lengths.push_back(remesh::distance(points[e.a], points[e.b]));
    if (size)
      for (std::size_t k = 0; k < edges_.size(); ++k) {
        const double asked = size->at(0.5 * (points[edges_[k].a] + points[edges_[k].b]), component);
        // Bins: below 1/4, 1/2, 1/sqrt 2, 1, sqrt 2, 2, 4, above.
        constexpr std::array<double, 7> bounds{0.25, 0.5, 0.70710678118654752, 1, 1.4142135623730951, 2, 4};
        const auto bin = std::upper_bound(bounds.begin(), bounds.end(), lengths[k] / asked) - bounds.begin();
        ++out_.edge_size_histogram[static_cast<std::size_t>(bin)];
      }
    out_.edge_length = distribution(lengths);
  }

  ShapeStatistics out_;
  std::size_t below_10_ = 0, above_ = 0;
  std::vector<double> min_dihedral_, max_dihedral_, solid_, radius_ratio_, aspect_, mean_ratio_;
  std::vector<SizedEdge> edges_;
};

}  // namespace

ShapeStatistics measure_shapes(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra) {
  Accumulator all;
  for (const Tetrahedron& t : tetrahedra) all.add(points, t);
  return all.finish(points, nullptr, no_index);
}

MeshQuality measure_quality(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                            const QualityOptions& options) {
  MeshQuality q;
  Accumulator all;
  std::vector<Accumulator> parts(mesh.n_components);
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    all.add(mesh.points, mesh.tetrahedra[t]);
    parts[mesh.component[t]].add(mesh.points, mesh.tetrahedra[t]);
  }
  q.whole = all.finish(mesh.points, options.size, no_index);
  for (Index c = 0; c < parts.size(); ++c) q.per_component.push_back(parts[c].finish(mesh.points, options.size, c));

  std::vector<WorstElement> bad;
  for (Index t = 0; t < mesh.tetrahedra.size(); ++t) {
    const Tetrahedron& v = mesh.tetrahedra[t];
    const std::array<Vec3, 4> p{mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]};
    const TetrahedronShape s = tetrahedron_shape(p[0], p[1], p[2], p[3]);
    if (s.min_dihedral >= options.bad_angle) continue;
    WorstElement w;
    w.tetrahedron = t;
    w.min_dihedral = s.min_dihedral;
    w.max_dihedral = s.max_dihedral;
    w.place = 0.25 * (p[0] + p[1] + p[2] + p[3]);
    bad.push_back(w);
  }
  std::sort(bad.begin(), bad.end(), [](const WorstElement& a, const WorstElement& b) {
    return a.min_dihedral != b.min_dihedral ? a.min_dihedral < b.min_dihedral : a.tetrahedron < b.tetrahedron;
  });
  q.n_bad = bad.size();
  if (bad.empty()) return q;
  const CauseFinder causes(plc, mesh, options);
  for (WorstElement& w : bad) {
    causes.explain(w);
    q.n_bad_forced += w.cause != ShapeCause::free;
  }
  // Those that nothing forces are what a user should look at: they lead the list, each group the worst first.
  std::stable_partition(bad.begin(), bad.end(), [](const WorstElement& w) { return w.cause == ShapeCause::free; });
  if (bad.size() > options.max_worst) bad.resize(options.max_worst);
  q.worst = std::move(bad);
  return q;
}

}  // namespace geomesh
