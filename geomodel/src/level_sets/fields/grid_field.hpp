// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A scalar field whose values are given at the nodes of a regular grid, and which is trilinear in each cell. Beyond
/// the grid, the cells at the border are extrapolated.
///
/// Its bounds are exact up to rounding: a trilinear function minus a linear one is linear in each coordinate alone, and
/// therefore takes its extremes over a box at the corners of the box.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "level_sets/fields/scalar_field.hpp"

namespace geomesh::geomodel {

class GridField final : public ScalarField {
 public:
  struct Lattice {
    std::array<std::size_t, 3> n{};  ///< number of grid nodes along x, y and z, at least two each
    Vec3 origin, spacing;            ///< position of the first grid node, and positive spacings
    std::vector<double> nodes;       ///< x runs fastest
  };
  /// Makes a field from a grid. Precondition: the number of values is that of the nodes, and all values are finite.
  explicit GridField(Lattice lattice);

  Box3 domain() const;
  void values(std::span<const Vec3> places, std::span<double> out) const override;
  double resolution() const override;
  bool has_bounds() const override { return true; }
  Range value_range(const Box3& box) const override;
  Range residual_range(const Box3& box, const LinearFunction& linear) const override;

 private:
  /// Least and greatest values of the field in blocks of 2^k cells along each axis, for one k; levels count k from 0.
  struct Level {
    std::array<std::size_t, 3> n{};
    std::vector<Range> blocks;
  };
  using Cells = std::array<std::array<std::size_t, 2>, 3>;  ///< block of grid cells: first and last along each axis

  double node(std::size_t i, std::size_t j, std::size_t k) const {
    return lattice_.nodes[i + lattice_.n[0] * (j + lattice_.n[1] * k)];
  }
  double at(const Vec3& p) const;
  double in_cell(const std::array<std::size_t, 3>& cell, const Vec3& p) const;
  double node_coordinate(std::size_t axis, std::size_t i) const;
  std::size_t cell_of(std::size_t axis, double x) const;
  Cells cells_of(const Box3& box) const;
  void build_levels();
  static Level coarser(const Level& fine);

  Lattice lattice_;
  std::vector<Level> levels_;
};

}  // namespace geomesh::geomodel
