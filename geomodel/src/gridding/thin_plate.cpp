// SPDX-License-Identifier: GPL-3.0-or-later
#include "gridding/thin_plate.hpp"

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <algorithm>
#include <array>
#include <cmath>

#include "geomesh/core/error.hpp"

namespace geomesh::geomodel {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

class NormalEquations {
 public:
  explicit NormalEquations(std::size_t n) : right_side_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(n))) {}

  /// Adds the term weight * (sum coefficient_k * x_k - value)^2 to the least-squares functional.
  template <std::size_t N>
  void add(const std::array<std::size_t, N>& nodes, const std::array<double, N>& coefficients, double value,
           double weight) {
    for (std::size_t i = 0; i < N; ++i) {
      right_side_[static_cast<Eigen::Index>(nodes[i])] += weight * coefficients[i] * value;
      for (std::size_t j = 0; j < N; ++j)
        entries_.emplace_back(static_cast<int>(nodes[i]), static_cast<int>(nodes[j]),
                              weight * coefficients[i] * coefficients[j]);
    }
  }

  /// Solves the normal equations. One step of iterative refinement compensates for their poor condition far from data.
  Eigen::VectorXd solve() const {
    Matrix matrix(right_side_.size(), right_side_.size());
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    const Eigen::SimplicialLDLT<Matrix> factors(matrix);
    GEOMESH_CHECK(factors.info() == Eigen::Success);
    Eigen::VectorXd x = factors.solve(right_side_);
    x += factors.solve(right_side_ - matrix * x);
    return x;
  }

 private:
  Eigen::VectorXd right_side_;
  std::vector<Eigen::Triplet<double>> entries_;
};

/// Adds the bending energy in second differences. Spacings are in smoothing lengths, so that the stiffness is one.
void add_bending(const PlateGrid& g, double du, double dv, NormalEquations& equations) {
  const double area = du * dv;
  const auto node = [&](std::size_t i, std::size_t j) { return j * g.n_u + i; };
  const std::array<double, 3> second{1, -2, 1};
  const std::array<double, 4> mixed{1, -1, -1, 1};
  for (std::size_t j = 0; j < g.n_v; ++j) {
    for (std::size_t i = 0; i < g.n_u; ++i) {
      if (i + 2 < g.n_u)
        equations.add<3>({node(i, j), node(i + 1, j), node(i + 2, j)}, second, 0, area / std::pow(du, 4));
      if (j + 2 < g.n_v)
        equations.add<3>({node(i, j), node(i, j + 1), node(i, j + 2)}, second, 0, area / std::pow(dv, 4));
      if (i + 1 < g.n_u && j + 1 < g.n_v)
        equations.add<4>({node(i, j), node(i + 1, j), node(i, j + 1), node(i + 1, j + 1)}, mixed, 0,
                         2 * area / std::pow(du * dv, 2));
    }
  }
}

/// Fits a plane by least squares: w = c0 + c1 (u - u0) + c2 (v - v0).
Eigen::Vector3d fit_plane(const PlateGrid& g, std::span<const Vec3> points) {
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  Eigen::Vector3d r = Eigen::Vector3d::Zero();
  const double width = g.du * static_cast<double>(g.n_u), height = g.dv * static_cast<double>(g.n_v);
  for (const Vec3& p : points) {
    const Eigen::Vector3d a(1, (p.x - g.u0) / width, (p.y - g.v0) / height);
    m += a * a.transpose();
    r += p.z * a;
  }
  const Eigen::Vector3d c = m.fullPivLu().solve(r);
  return {c[0], c[1] / width, c[2] / height};
}

}  // namespace

std::vector<double> fit_thin_plate(const PlateGrid& g, std::span<const Vec3> points, double smoothing) {
  const Eigen::Vector3d plane = fit_plane(g, points);
  const auto plane_at = [&](double u, double v) { return plane[0] + plane[1] * (u - g.u0) + plane[2] * (v - g.v0); };
  NormalEquations equations(g.n_u * g.n_v);
  // Lengths are divided by the smoothing length, so that the matrix of the bending energy is the same for all grids.
  // The sum of the squared residuals then has the weight A / n, for n points in the grid's area A.
  const double du = g.du / smoothing, dv = g.dv / smoothing;
  const double weight = du * dv * static_cast<double>((g.n_u - 1) * (g.n_v - 1)) / static_cast<double>(points.size());
  for (const Vec3& p : points) {
    const double u = (p.x - g.u0) / g.du, v = (p.y - g.v0) / g.dv;
    const std::size_t i = std::min(static_cast<std::size_t>(std::max(u, 0.0)), g.n_u - 2),
                      j = std::min(static_cast<std::size_t>(std::max(v, 0.0)), g.n_v - 2);
    const double s = u - static_cast<double>(i), t = v - static_cast<double>(j);
    const std::size_t a = j * g.n_u + i;
    const bool lower = s >= t;  // whether the point is in the lower of the two triangles of its grid cell
    equations.add<3>({a, lower ? a + 1 : a + g.n_u, a + g.n_u + 1},
                     {1 - std::max(s, t), std::abs(s - t), std::min(s, t)}, p.z - plane_at(p.x, p.y), weight);
  }
  add_bending(g, du, dv, equations);
  const Eigen::VectorXd x = equations.solve();
  std::vector<double> heights;
  for (std::size_t j = 0; j < g.n_v; ++j)
    for (std::size_t i = 0; i < g.n_u; ++i)
      heights.push_back(plane_at(g.u0 + static_cast<double>(i) * g.du, g.v0 + static_cast<double>(j) * g.dv) +
                        x[static_cast<Eigen::Index>(j * g.n_u + i)]);
  return heights;
}

}  // namespace geomesh::geomodel
