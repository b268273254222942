// SPDX-License-Identifier: GPL-3.0-or-later
// Declared in geomesh/geomodel/solver_verdict.hpp.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "geomesh/core/quality.hpp"
#include "geomesh/geomodel/solver_verdict.hpp"

namespace geomesh::geomodel {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double length(const Vec3& v) { return std::sqrt(dot(v, v)); }

/// As a solver computes it.
double volume(const std::array<Vec3, 4>& p) { return dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]) / 6; }

double with_16_digits(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.15e", x);
  return std::strtod(text, nullptr);
}

double greatest_face_area(const std::array<Vec3, 4>& p) {
  double greatest = 0;
  for (unsigned i = 0; i < 4; ++i)
    greatest =
        std::max(greatest, 0.5 * length(cross(p[(i + 2) % 4] - p[(i + 1) % 4], p[(i + 3) % 4] - p[(i + 1) % 4])));
  return greatest;
}

Vec3 centroid(const std::array<Vec3, 4>& p) { return 0.25 * ((p[0] + p[1]) + (p[2] + p[3])); }

/// Ends and length of the shortest edge.
struct Edge {
  Vec3 middle;
  double length;
};
Edge shortest_edge(const std::array<Vec3, 4>& p) {
  Edge shortest{{}, infinity};
  for (unsigned i = 0; i < 4; ++i)
    for (unsigned j = i + 1; j < 4; ++j)
      if (const double l = length(p[j] - p[i]); l < shortest.length) shortest = {0.5 * (p[i] + p[j]), l};
  return shortest;
}

class Judge {
 public:
  Judge(const MeshForSolver& mesh, const SolverLimits& limits) : mesh_(mesh), limits_(limits) {}

  SolverVerdict run() {
    v_.n_tetrahedra = mesh_.tetrahedra.size();
    if (v_.n_tetrahedra == 0) return v_;
    v_.least_volume = v_.least_volume_16_digits = v_.least_edge = v_.min_dihedral = least_over_size_ = infinity;
    round_points();
    for (std::size_t t = 0; t < v_.n_tetrahedra; ++t) look_at(t);
    v_.least_edge_over_size = least_over_size_ < infinity ? least_over_size_ : 0;
    v_.least_edge_over_diagonal = v_.least_edge / diagonal();
    judge_steps();
    return v_;
  }

 private:
  void round_points() {
    for (const Vec3& p : mesh_.points)
      rounded_.push_back({with_16_digits(p.x), with_16_digits(p.y), with_16_digits(p.z)});
  }

  double diagonal() const {
    Box3 box;
    for (const Vec3& p : mesh_.points) box.add(p);
    return length(box.max - box.min);
  }

  std::array<Vec3, 4> corners(std::span<const Vec3> points, std::size_t t) const {
    const Tetrahedron& v = mesh_.tetrahedra[t];
    return {points[v[0]], points[v[1]], points[v[2]], points[v[3]]};
  }

  void look_at(std::size_t t) {
    const std::array<Vec3, 4> p = corners(mesh_.points, t);
    const TetrahedronShape shape = tetrahedron_shape(p[0], p[1], p[2], p[3]);
    const double cube = std::pow(shape.longest_edge, 3), as_is = volume(p) / cube,
                 as_written = volume(corners(rounded_, t)) / cube;
    v_.n_not_positive += !(std::min(as_is, as_written) > 0);
    if (as_is < v_.least_volume) v_.flattest = {t, centroid(p)};
    v_.least_volume = std::min(v_.least_volume, as_is);
    v_.least_volume_16_digits = std::min(v_.least_volume_16_digits, as_written);
    look_at_angles(t, shape, std::min(as_is, as_written));
    look_at_edges(t, p);
    step_.push_back(3 * std::max(volume(p), 0.0) / greatest_face_area(p) / velocity(t));
  }

  void look_at_angles(std::size_t t, const TetrahedronShape& s, double least_volume) {
    if (s.min_dihedral < v_.min_dihedral) v_.sharpest = {t, centroid(corners(mesh_.points, t))};
    v_.min_dihedral = std::min(v_.min_dihedral, s.min_dihedral);
    v_.max_dihedral = std::max(v_.max_dihedral, s.max_dihedral);
    v_.n_implicit += !(least_volume >= limits_.least_volume) || s.min_dihedral < limits_.least_implicit_angle ||
                     s.max_dihedral > limits_.most_implicit_angle;
    v_.n_iterative += s.min_dihedral < limits_.least_iterative_angle || s.max_dihedral > limits_.most_iterative_angle;
    v_.n_flux += s.max_dihedral > limits_.most_flux_angle;
  }

  void look_at_edges(std::size_t t, const std::array<Vec3, 4>& p) {
    const Edge edge = shortest_edge(p);
    v_.least_edge = std::min(v_.least_edge, edge.length);
    if (mesh_.size) least_over_size_ = std::min(least_over_size_, edge.length / mesh_.size(t, edge.middle));
  }

  /// 1 where it is not known.
  double velocity(std::size_t t) {
    const double v = mesh_.velocity ? mesh_.velocity(t) : 0;
    v_.has_velocities |= v > 0;
    return v > 0 ? v : 1;
  }

  void judge_steps() {
    constexpr std::size_t n_left_out = 10;
    const auto least = std::min_element(step_.begin(), step_.end());
    v_.smallest_step.tetrahedron = static_cast<std::size_t>(least - step_.begin());
    v_.smallest_step.place = centroid(corners(mesh_.points, v_.smallest_step.tetrahedron));
    std::vector<double> sorted = step_;
    std::sort(sorted.begin(), sorted.end());
    v_.time_step = sorted.front();
    v_.time_step_without_worst_ten = sorted[std::min(n_left_out, sorted.size() - 1)];
    v_.median_time_step = sorted[sorted.size() / 2];
    for (const double s : sorted) v_.n_explicit += s < limits_.least_step * v_.median_time_step;
  }

  const MeshForSolver& mesh_;
  const SolverLimits& limits_;
  SolverVerdict v_;
  std::vector<Vec3> rounded_;
  std::vector<double> step_;
  double least_over_size_ = 0;
};

}  // namespace

SolverVerdict judge_for_solvers(const MeshForSolver& mesh, const SolverLimits& limits) {
  return Judge(mesh, limits).run();
}

}  // namespace geomesh::geomodel
