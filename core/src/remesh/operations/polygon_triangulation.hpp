// SPDX-License-Identifier: MIT
/// @file
/// Best triangulation of the ring of vertices around an edge, from which the cells that replace the edge are built.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "mesh/edge_shell.hpp"
#include "remesh/operations/improve.hpp"

namespace geomesh::remesh {

// Largest number of vertices around an edge that may be removed. The cost is cubic in it, and edges with more vertices
// are hardly ever worth removing (Klingner and Shewchuk 2007, section 3.2).
inline constexpr std::size_t max_ring = 12;

/// Finds the best triangulation of a polygon of vertices around an edge; each triangle stands for two new cells. The
/// two cells at a side of the polygon share the dihedral angle that a removed cell had there, so one of them has at
/// most half of it. This bound excludes most edges before any shape is computed.
class PolygonTriangulation {
 public:
  /// `is_whole_ring`: whether the side from the last vertex of the polygon to the first belongs to the ring as well.
  PolygonTriangulation(const DomainMesh& mesh, VertexIndex a, VertexIndex b, const std::vector<VertexIndex>& polygon,
                       bool is_whole_ring)
      : mesh_(mesh),
        measure_(mesh.measure()),
        a_(a),
        b_(b),
        p_(polygon),
        n_(polygon.size()),
        n_sides_(n_ < 3          ? 0
                 : is_whole_ring ? n_
                                 : n_ - 1) {}

  /// Returns the worst shape of the best triangulation, or any value up to `enough` if that shape is not above it.
  double solve(double enough) {
    for (std::size_t i = 0; i < n_sides_; ++i)
      if (bound_at_side(i) <= enough) return enough;
    return triangulate(1, enough, [&](const Shell::Span& s, double left, double right) {
      const double rest = std::min(left, right);
      return rest <= s.best ? rest : std::min(rest, triangle_shape(s.i, s.k, s.j, s.best));
    });
  }

  /// Returns the largest sum of (worth - mean) over the new cells among the triangulations that the goal permits;
  /// `before` is the worst shape of the removed cells. Returns minus infinity if no sum is above `needed`.
  double solve(const MeanGoal& goal, double before, double needed) {
    const double floor = goal.least_after(before), mean = goal.mean;
    constexpr double none = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < n_sides_; ++i) bound_[i] = bound_at_side(i);
    const double most = triangulate(0, none, [&](const Shell::Span& s, double left, double right) {
      return left + right + 2 * bound_of_triangle(s.i, s.k, s.j) - 2 * mean;
    });
    if (most <= needed) return none;
    return triangulate(0, none, [&](const Shell::Span& s, double left, double right) {
      const double rest = left + right - 2 * mean;
      if (!(rest + 2 * bound_of_triangle(s.i, s.k, s.j) > s.best)) return none;
      const auto [upper, lower] = shapes_on(s.i, s.k, s.j);
      return upper > floor && lower > floor ? rest + measure_.worth(upper) + measure_.worth(lower) : none;
    });
  }

  void append_cells(Index component, std::vector<NewCell>& cells) const {
    shell_.for_each_triangle([&](std::size_t i, std::size_t k, std::size_t j) {
      cells.push_back({{p_[i], p_[k], p_[j], b_}, component, {}});
      cells.push_back({{p_[j], p_[k], p_[i], a_}, component, {}});
    });
  }

 private:
  using Shell = EdgeShell<double, max_ring + 1>;

  /// Finds the best triangulation of the polygon around an edge by dynamic programming. A side of the polygon has the
  /// value `of_edge`; values up to `least` are dropped. `span_value` combines the values beside a triangle (EdgeShell).
  template <class SpanValue>
  double triangulate(double of_edge, double least, const SpanValue& span_value) {
    struct Goal {
      double of_edge, least;
      const SpanValue& span_value;
      double edge() const { return of_edge; }
      double none() const { return least; }
      static constexpr bool allows(std::size_t, std::size_t) { return true; }
      static constexpr bool is_enough(double) { return false; }
      double value(const Shell::Span& s, double left, double right) const { return span_value(s, left, right); }
    };
    return shell_.triangulate(n_, Goal{of_edge, least, span_value});
  }

  /// Returns an upper bound of the worse and the mean shape of the two new cells at side i of the ring around the edge.
  double bound_at_side(std::size_t i) const {
    const Vec3 &x = mesh_.point(p_[i]), &y = mesh_.point(p_[i + 1 == n_ ? 0 : i + 1]);
    return measure_.most_of_half_angle(mesh_.point(a_), mesh_.point(b_), x, y);
  }
  double bound_of_triangle(std::size_t i, std::size_t k, std::size_t j) const {
    double bound = measure_.largest();
    if (k == i + 1) bound = std::min(bound, bound_[i]);
    if (j == k + 1) bound = std::min(bound, bound_[k]);
    if (i == 0 && j + 1 == n_ && n_sides_ == n_) bound = std::min(bound, bound_[j]);
    return bound;
  }

  std::array<double, 2> shapes_on(std::size_t i, std::size_t j, std::size_t k) const {
    const Vec3 &x = mesh_.point(p_[i]), &y = mesh_.point(p_[j]), &z = mesh_.point(p_[k]);
    return {measure_.shape(x, y, z, mesh_.point(b_)), measure_.shape(z, y, x, mesh_.point(a_))};
  }

  double triangle_shape(std::size_t i, std::size_t j, std::size_t k, double enough) const {
    const Vec3 &x = mesh_.point(p_[i]), &y = mesh_.point(p_[j]), &z = mesh_.point(p_[k]);
    const double upper = measure_.shape(x, y, z, mesh_.point(b_));
    return upper <= enough ? upper : std::min(upper, measure_.shape(z, y, x, mesh_.point(a_)));
  }

  const DomainMesh& mesh_;
  const CellQuality& measure_;
  VertexIndex a_, b_;
  const std::vector<VertexIndex>& p_;
  std::size_t n_, n_sides_;
  double bound_[max_ring + 1];
  Shell shell_;
};

}  // namespace geomesh::remesh
