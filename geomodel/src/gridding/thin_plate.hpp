// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Fits a smooth surface to points: the discretised thin plate on a regular grid.
#pragma once

#include <span>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// A regular grid in the (u, v) plane.
struct PlateGrid {
  double u0 = 0, v0 = 0, du = 1, dv = 1;
  std::size_t n_u = 0, n_v = 0;
};

/// Returns the heights at the grid nodes (index v * n_u + u) that minimise the functional of grid_points. Every point
/// must lie on the grid; points must not all lie on one line.
std::vector<double> fit_thin_plate(const PlateGrid& grid, std::span<const Vec3> points, double smoothing);

}  // namespace geomesh::geomodel
