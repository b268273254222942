// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <numeric>

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

struct TetrahedronAngles {
  double least = 0, largest = 0;
};

TetrahedronShape shape_of(std::span<const Vec3> points, const Tetrahedron& t) {
  return tetrahedron_shape(points[t[0]], points[t[1]], points[t[2]], points[t[3]]);
}

/// An edge with a component that it is in.
struct SizedEdge {
  VertexIndex a, b;
  Index component;
  auto operator<=>(const SizedEdge&) const = default;
};

/// Gathers shapes one by one, then makes the statistics.
class Accumulator {
 public:
  void add(const TetrahedronShape& s, const Tetrahedron& t, Index component) {
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
    for (const auto& e : edge_vertices) edges_.push_back({std::min(t[e[0]], t[e[1]]), std::max(t[e[0]], t[e[1]]), component});
  }

  ShapeStatistics finish(std::span<const Vec3> points, const SizeField* size) {
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
    measure_edges(points, size);
    return out_;
  }

 private:
  /// The size asked of an edge is the least that is asked at its middle in the components that it is in.
  void measure_edges(std::span<const Vec3> points, const SizeField* size) {
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    std::vector<double> lengths;
    for (std::size_t i = 0, j; i < edges_.size(); i = j) {
      const SizedEdge& e = edges_[i];
      lengths.push_back(remesh::distance(points[e.a], points[e.b]));
      double asked = std::numeric_limits<double>::infinity();
      for (j = i; j < edges_.size() && edges_[j].a == e.a && edges_[j].b == e.b; ++j)
        if (size) asked = std::min(asked, size->at(0.5 * (points[e.a] + points[e.b]), edges_[j].component));
      if (!size) continue;
      // Bins: below 1/4, 1/2, 1/sqrt 2, 1, sqrt 2, 2, 4, above.
      constexpr std::array<double, 7> bounds{0.25, 0.5, 0.70710678118654752, 1, 1.4142135623730951, 2, 4};
      const auto bin = std::upper_bound(bounds.begin(), bounds.end(), lengths.back() / asked) - bounds.begin();
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
  for (const Tetrahedron& t : tetrahedra) all.add(shape_of(points, t), t, no_index);
  return all.finish(points, nullptr);
}

namespace {

/// Elements below the bad angle, and the worst whatever they are up to the number that is to be listed; the worst first.
std::vector<WorstElement> worst_elements(const ConstrainedTetrahedralization& mesh, const QualityOptions& options,
                                         const std::vector<TetrahedronAngles>& angles) {
  std::vector<Index> order(angles.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto first_good = std::partition(order.begin(), order.end(), [&](Index t) { return angles[t].least < options.bad_angle; });
  const auto worse = [&](Index a, Index b) { return angles[a].least != angles[b].least ? angles[a].least < angles[b].least : a < b; };
  const auto n_bad = static_cast<std::size_t>(first_good - order.begin());
  const std::size_t n = std::max(n_bad, std::min(options.min_worst, order.size()));
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(n), order.end(), worse);
  std::vector<WorstElement> worst;
  for (std::size_t i = 0; i < n; ++i) {
    const Tetrahedron& v = mesh.tetrahedra[order[i]];
    WorstElement w;
    w.tetrahedron = order[i];
    w.min_dihedral = angles[order[i]].least;
    w.max_dihedral = angles[order[i]].largest;
    w.place = 0.25 * (mesh.points[v[0]] + mesh.points[v[1]] + mesh.points[v[2]] + mesh.points[v[3]]);
    worst.push_back(w);
  }
  return worst;
}

}  // namespace

MeshQuality measure_quality(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                            const QualityOptions& options) {
  MeshQuality q;
  Accumulator all;
  const bool grouped = !options.group.empty();
  std::vector<Accumulator> parts(grouped ? options.n_groups : mesh.n_components);
  std::vector<TetrahedronAngles> angles(mesh.tetrahedra.size());
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    const TetrahedronShape s = shape_of(mesh.points, mesh.tetrahedra[t]);
    angles[t] = {s.min_dihedral, s.max_dihedral};
    all.add(s, mesh.tetrahedra[t], mesh.component[t]);
    parts[grouped ? options.group[t] : mesh.component[t]].add(s, mesh.tetrahedra[t], mesh.component[t]);
  }
  q.whole = all.finish(mesh.points, options.size);
  for (Accumulator& part : parts) q.per_component.push_back(part.finish(mesh.points, options.size));

  q.worst = worst_elements(mesh, options, angles);
  if (q.worst.empty()) return q;
  CauseFinder causes(plc, mesh, options);
  for (WorstElement& w : q.worst) {
    causes.explain(w);
    q.n_bad += w.min_dihedral < options.bad_angle;
    q.n_bad_forced += w.min_dihedral < options.bad_angle && w.cause != ShapeCause::free;
  }
  // Those that nothing forces are what a user should look at: they lead the list, each kind the worst first.
  std::stable_partition(q.worst.begin(), q.worst.end(), [](const WorstElement& w) { return w.cause == ShapeCause::free; });
  if (q.worst.size() > options.max_worst) q.worst.resize(options.max_worst);
  return q;
}

}  // namespace geomesh
