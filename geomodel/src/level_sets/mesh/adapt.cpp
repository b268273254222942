// SPDX-License-Identifier: GPL-3.0-or-later
#include "level_sets/mesh/adapt.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geomesh/core/error.hpp"

namespace geomesh::geomodel {
namespace {

constexpr std::array<std::array<std::size_t, 2>, 6> edges_of_cell{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// The quadratic function that interpolates the scalar field at the corners and edge midpoints of one cell.
struct Quadratic {
  std::array<Vec3, 4> corners;
  std::array<double, 4> values;
  std::array<double, 6> bend;  ///< for each edge: the field's value at the midpoint minus the mean of those at the ends

  Quadratic(const BackgroundMesh& mesh, const BackgroundMesh::Cell& cell) : corners(mesh.corners(cell)) {
    for (std::size_t i = 0; i < 4; ++i) values[i] = mesh.value(cell.v[i]);
    for (std::size_t e = 0; e < 6; ++e) {
      const auto [i, j] = edges_of_cell[e];
      bend[e] = mesh.midpoint_value(cell.v[i], cell.v[j]) - 0.5 * (values[i] + values[j]);
    }
  }

  Range corner_range() const {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return {*low, *high};
  }

  /// Returns the range of the quadratic function's Bernstein coefficients, which contains all its values in the cell.
  Range range() const {
    Range range = corner_range();
    for (std::size_t e = 0; e < 6; ++e) {
      const auto [i, j] = edges_of_cell[e];
      const double coefficient = 0.5 * (values[i] + values[j]) + 2 * bend[e];
      range = {std::min(range.low, coefficient), std::max(range.high, coefficient)};
    }
    return range;
  }

  double greatest_bend() const {
    double greatest = 0;
    for (const double b : bend) greatest = std::max(greatest, std::abs(b));
    return greatest;
  }

  /// Returns the least slope along `direction`, in one cell, of the quadratic function that interpolates the field. The
  /// slope is linear, so it is least at a corner. At corner i it is the slope of the linear function whose value at
  /// each corner j is raised by four times the bend of edge ij (the value at its midpoint minus the mean at its ends).
  double least_slope(const Vec3& direction) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t at = 0; at < 4; ++at) {
      std::array<double, 4> raised = values;
      for (std::size_t e = 0; e < 6; ++e) {
        const auto [i, j] = edges_of_cell[e];
        if (i == at) raised[j] += 4 * bend[e];
        if (j == at) raised[i] += 4 * bend[e];
      }
      least = std::min(least, dot(linear_in(corners, raised).gradient, direction));
    }
    return least;
  }
};

Box3 bounds(const std::array<Vec3, 4>& corners) {
  Box3 box;
  for (const Vec3& p : corners) box.add(p);
  return box;
}

class Adapter {
 public:
  Adapter(BackgroundMesh& mesh, const ScalarField& field, const std::vector<double>& values, const AdaptLimits& limits)
      : mesh_(mesh), field_(field), values_(values), limits_(limits) {}

  AdaptResult adapt() {
    do {
      refine_by_samples();
    } while (field_.has_bounds() && refine_what_is_not_proven());
    return std::move(result_);
  }

 private:
  bool any_value_in(const Range& range) const {
    const auto first = std::lower_bound(values_.begin(), values_.end(), range.low);
    return first != values_.end() && *first <= range.high;
  }

  /// Returns true if bounds of the field prove, without samples, that no isosurface passes through a cell.
  bool passes_no_isosurface(const BackgroundMesh::Cell& cell) const {
    return field_.has_bounds() && !any_value_in(field_.value_range(bounds(mesh_.corners(cell))));
  }

  bool needs_bisection(const BackgroundMesh::Cell& cell) {
    const Quadratic q(mesh_, cell);
    if (!any_value_in(q.range())) return false;
    const Vec3 gradient = linear_in(q.corners, q.values).gradient;
    const bool is_one_sheet = q.least_slope(gradient) > 0;
    const bool is_near = !any_value_in(q.corner_range()) || q.greatest_bend() <= limits_.distance * length_of(gradient);
    if (is_one_sheet && is_near) return false;
    const double edge = BackgroundMesh::longest_edge(q.corners);
    if (edge > (is_near ? limits_.least_sheet_edge : limits_.least_edge)) return true;
    if (!is_one_sheet) result_.unresolved.push_back(bounds(q.corners));
    return false;
  }

  void refine_by_samples() {
    for (;;) {
      for (std::size_t c = 0; c < mesh_.cells().size(); ++c)
        if (!mesh_.cells()[c].is_settled && passes_no_isosurface(mesh_.cells()[c])) mesh_.settle(c);
      mesh_.sample_midpoints();
      std::vector<std::size_t> chosen;
      for (std::size_t c = 0; c < mesh_.cells().size(); ++c) {
        if (mesh_.cells()[c].is_settled) continue;
        mesh_.settle(c);
        if (needs_bisection(mesh_.cells()[c])) chosen.push_back(c);
      }
      if (chosen.empty()) return;
      bisect(chosen);
    }
  }

  void bisect(const std::vector<std::size_t>& chosen) {
    mesh_.bisect(chosen);
    if (mesh_.cells().size() <= limits_.most_cells) return;
    throw Error(
        ErrorKind::cannot_mesh,
        "more than " + std::to_string(limits_.most_cells) +
            " cells would be needed to follow the isosurface; allow a larger mesh.surfaces_within or give the field "
            "on a smoother grid");
  }

  /// Returns the vertices of cells through which an isosurface passes according to the signs at their corners.
  std::vector<char> near_isosurface() const {
    std::vector<char> is_near(mesh_.n_points(), 0);
    for (const BackgroundMesh::Cell& cell : mesh_.cells()) {
      const auto [low, high] =
          std::minmax({mesh_.value(cell.v[0]), mesh_.value(cell.v[1]), mesh_.value(cell.v[2]), mesh_.value(cell.v[3])});
      if (!any_value_in({low, high})) continue;
      for (const VertexIndex v : cell.v) is_near[v] = 1;
    }
    return is_near;
  }

  bool is_proven_free(const BackgroundMesh::Cell& cell) const {
    const std::array<Vec3, 4> corners = mesh_.corners(cell);
    if (!any_value_in(field_.value_range(bounds(corners)))) return true;
    const std::array<double, 4> values{mesh_.value(cell.v[0]), mesh_.value(cell.v[1]), mesh_.value(cell.v[2]),
                                       mesh_.value(cell.v[3])};
    const Range residual = field_.residual_range(bounds(corners), linear_in(corners, values));
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return !any_value_in({*low + residual.low, *high + residual.high});
  }

  bool refine_what_is_not_proven() {
    const std::vector<char> is_near = near_isosurface();
    std::vector<std::size_t> chosen;
    for (std::size_t c = 0; c < mesh_.cells().size(); ++c) {
      const BackgroundMesh::Cell& cell = mesh_.cells()[c];
      const bool touches = std::any_of(cell.v.begin(), cell.v.end(), [&](VertexIndex v) { return is_near[v] != 0; });
      const bool is_small = BackgroundMesh::longest_edge(mesh_.corners(cell)) <= limits_.least_sheet_edge;
      if (touches || is_small || is_proven_free(cell)) continue;
      chosen.push_back(c);
    }
    if (!chosen.empty()) bisect(chosen);
    return !chosen.empty();
  }

  BackgroundMesh& mesh_;
  const ScalarField& field_;
  const std::vector<double>& values_;
  const AdaptLimits& limits_;
  AdaptResult result_;
};

}  // namespace

LinearFunction linear_in(const std::array<Vec3, 4>& corners, const std::array<double, 4>& values) {
  const Vec3 a = corners[1] - corners[0], b = corners[2] - corners[0], c = corners[3] - corners[0];
  const Vec3 bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  const double volume = dot(a, bc);
  if (volume == 0) return {corners[0], values[0], {}};
  const Vec3 sum = (values[1] - values[0]) * bc + (values[2] - values[0]) * ca + (values[3] - values[0]) * ab;
  return {corners[0], values[0], (1 / volume) * sum};
}

AdaptResult adapt(BackgroundMesh& mesh, const ScalarField& field, const std::vector<double>& values,
                  const AdaptLimits& limits) {
  return Adapter(mesh, field, values, limits).adapt();
}

}  // namespace geomesh::geomodel
