// SPDX-License-Identifier: GPL-3.0-or-later
// Declared in geomesh/geomodel/solver_verdict.hpp.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "common/chunks.hpp"
#include "geomesh/core/quality.hpp"
#include "geomesh/geomodel/solver_verdict.hpp"

namespace geomesh::geomodel {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double length(const Vec3& v) { return std::sqrt(dot(v, v)); }

/// Computes the volume of a tetrahedron in the same way as a solver.
double volume(const std::array<Vec3, 4>& p) { return dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]) / 6; }

double with_16_digits(double x) {
  char text[32];
  const auto written = std::to_chars(text, text + sizeof text, x, std::chars_format::scientific, 15);
  double read = x;
  std::from_chars(text, written.ptr, read);
  return read;
}

double greatest_face_area(const std::array<Vec3, 4>& p) {
  double greatest = 0;  // squared, four times
  for (unsigned i = 0; i < 4; ++i) {
    const Vec3 normal = cross(p[(i + 2) % 4] - p[(i + 1) % 4], p[(i + 3) % 4] - p[(i + 1) % 4]);
    greatest = std::max(greatest, dot(normal, normal));
  }
  return 0.5 * std::sqrt(greatest);
}

Vec3 centroid(const std::array<Vec3, 4>& p) { return 0.25 * ((p[0] + p[1]) + (p[2] + p[3])); }

/// Vectors and lengths of edges: the vector of an element's shortest edge, and the length of its longest edge.
struct Edges {
  Vec3 middle;
  double shortest, longest;
};
Edges edges_of(const std::array<Vec3, 4>& p) {
  Edges edges{{}, infinity, 0};
  for (unsigned i = 0; i < 4; ++i)
    for (unsigned j = i + 1; j < 4; ++j) {
      const Vec3 along = p[j] - p[i];
      const double squared = dot(along, along);
      if (squared < edges.shortest) edges.middle = 0.5 * (p[i] + p[j]), edges.shortest = squared;
      edges.longest = std::max(edges.longest, squared);
    }
  edges.shortest = std::sqrt(edges.shortest), edges.longest = std::sqrt(edges.longest);
  return edges;
}

/// Results of the checks for solvers on some of the elements, without time steps, which need all elements.
struct Tally {
  Tally() { v.least_volume = v.least_volume_16_digits = v.least_edge = v.min_dihedral = infinity; }
  SolverVerdict v;
  double least_over_size = infinity;

  void join(const Tally& o) {
    if (o.v.least_volume < v.least_volume) v.flattest = o.v.flattest;
    if (o.v.min_dihedral < v.min_dihedral) v.sharpest = o.v.sharpest;
    v.least_volume = std::min(v.least_volume, o.v.least_volume);
    v.least_volume_16_digits = std::min(v.least_volume_16_digits, o.v.least_volume_16_digits);
    v.least_edge = std::min(v.least_edge, o.v.least_edge);
    v.min_dihedral = std::min(v.min_dihedral, o.v.min_dihedral);
    v.max_dihedral = std::max(v.max_dihedral, o.v.max_dihedral);
    v.n_not_positive += o.v.n_not_positive;
    v.n_implicit += o.v.n_implicit;
    v.n_iterative += o.v.n_iterative;
    v.n_flux += o.v.n_flux;
    v.has_velocities |= o.v.has_velocities;
    least_over_size = std::min(least_over_size, o.least_over_size);
  }
};

class Judge {
 public:
  Judge(const MeshForSolver& mesh, const SolverLimits& limits)
      : mesh_(mesh), limits_(limits), rounded_(mesh.points.size()), step_(mesh.tetrahedra.size()) {}

  SolverVerdict run() {
    if (mesh_.tetrahedra.empty()) return {};
    Chunks(mesh_.points.size()).for_each(mesh_.threads, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Vec3& p = mesh_.points[i];
        rounded_[i] = {with_16_digits(p.x), with_16_digits(p.y), with_16_digits(p.z)};
      }
    });
    const Chunks chunks(mesh_.tetrahedra.size());
    std::vector<Tally> tallies(chunks.size());
    chunks.for_each(mesh_.threads, [&](std::size_t k, std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) look_at(t, tallies[k]);
    });
    Tally all;
    for (const Tally& t : tallies) all.join(t);
    all.v.n_tetrahedra = mesh_.tetrahedra.size();
    all.v.least_edge_over_size = all.least_over_size < infinity ? all.least_over_size : 0;
    all.v.least_edge_over_diagonal = all.v.least_edge / diagonal();
    judge_steps(all.v);
    return all.v;
  }

 private:
  double diagonal() const {
    Box3 box;
    for (const Vec3& p : mesh_.points) box.add(p);
    return length(box.max - box.min);
  }

  std::array<Vec3, 4> corners(std::span<const Vec3> points, std::size_t t) const {
    const Tetrahedron& v = mesh_.tetrahedra[t];
    return {points[v[0]], points[v[1]], points[v[2]], points[v[3]]};
  }

  void look_at(std::size_t t, Tally& tally) {
    const std::array<Vec3, 4> p = corners(mesh_.points, t);
    const Edges edges = edges_of(p);
    const double cube = edges.longest * edges.longest * edges.longest, size = volume(p), as_is = size / cube,
                 as_written = volume(corners(rounded_, t)) / cube;
    SolverVerdict& v = tally.v;
    v.n_not_positive += !(std::min(as_is, as_written) > 0);
    if (as_is < v.least_volume) v.flattest = {t, centroid(p)};
    v.least_volume = std::min(v.least_volume, as_is);
    v.least_volume_16_digits = std::min(v.least_volume_16_digits, as_written);
    look_at_angles(t, dihedral_range(p[0], p[1], p[2], p[3]), std::min(as_is, as_written), v);
    look_at_edges(t, edges, tally);
    step_[t] = 3 * std::max(size, 0.0) / greatest_face_area(p) / velocity(t, v);
  }

  void look_at_angles(std::size_t t, const DihedralRange& s, double least_volume, SolverVerdict& v) const {
    if (s.least < v.min_dihedral) v.sharpest = {t, centroid(corners(mesh_.points, t))};
    v.min_dihedral = std::min(v.min_dihedral, s.least);
    v.max_dihedral = std::max(v.max_dihedral, s.greatest);
    v.n_implicit += !(least_volume >= limits_.least_volume) || s.least < limits_.least_implicit_angle ||
                    s.greatest > limits_.most_implicit_angle;
    v.n_iterative += s.least < limits_.least_iterative_angle || s.greatest > limits_.most_iterative_angle;
    v.n_flux += s.greatest > limits_.most_flux_angle;
  }

  void look_at_edges(std::size_t t, const Edges& edges, Tally& tally) const {
    tally.v.least_edge = std::min(tally.v.least_edge, edges.shortest);
    if (!mesh_.size || !(edges.shortest < tally.least_over_size * mesh_.largest_size)) return;
    const double enough = edges.shortest / tally.least_over_size, size = mesh_.size(t, edges.middle, enough);
    if (size > enough) tally.least_over_size = std::min(tally.least_over_size, edges.shortest / size);
  }

  /// Returns the velocity of waves in a tetrahedron; 1 if it is not known.
  double velocity(std::size_t t, SolverVerdict& verdict) const {
    const double v = mesh_.velocity ? mesh_.velocity(t) : 0;
    verdict.has_velocities |= v > 0;
    return v > 0 ? v : 1;
  }

  void judge_steps(SolverVerdict& v) {
    constexpr std::size_t n_left_out = 10;
    const auto least = std::min_element(step_.begin(), step_.end());
    v.smallest_step.tetrahedron = static_cast<std::size_t>(least - step_.begin());
    v.smallest_step.place = centroid(corners(mesh_.points, v.smallest_step.tetrahedron));
    const auto nth = [&](std::size_t n) {
      const auto at = step_.begin() + static_cast<std::ptrdiff_t>(n);
      std::nth_element(step_.begin(), at, step_.end());
      return *at;
    };
    v.time_step = *least;
    v.time_step_without_worst_ten = nth(std::min(n_left_out, step_.size() - 1));
    v.median_time_step = nth(step_.size() / 2);
    for (const double s : step_) v.n_explicit += s < limits_.least_step * v.median_time_step;
  }

  const MeshForSolver& mesh_;
  const SolverLimits& limits_;
  std::vector<Vec3> rounded_;
  std::vector<double> step_;  // explicit time step of each element; computing the median changes their order
};

}  // namespace

SolverVerdict judge_for_solvers(const MeshForSolver& mesh, const SolverLimits& limits) {
  return Judge(mesh, limits).run();
}

}  // namespace geomesh::geomodel
