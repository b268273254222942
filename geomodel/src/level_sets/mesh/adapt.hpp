// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Refines a background mesh until the isosurfaces in every cell are simple and nearly linear.
#pragma once

#include <cstddef>
#include <vector>

#include "level_sets/mesh/background_mesh.hpp"

namespace geomesh::geomodel {

struct AdaptLimits {
  double distance = 0;    ///< largest distance between the linear isosurface of a cell and that of the field itself
  double least_edge = 0;  ///< cells whose edges are all shorter than this length are not refined
  /// Cells whose edges are all shorter than this are not refined if the only problem is that nearly touching parts of
  /// an isosurface are not separated.
  double least_sheet_edge = 0;
  std::size_t most_cells = 0;
};

struct AdaptResult {
  /// Bounding boxes of background cells too small to bisect in which an isosurface may still have several parts.
  std::vector<Box3> unresolved;
};

/// Bisects cells of the mesh where an isosurface of `values` (ascending) may pass, until each of these cells fulfils
/// two conditions:
/// 1. the field increases along one direction throughout the cell, so that no isosurface passes through it twice (the
///    small normal variation of Plantinga and Vegter 2004), and
/// 2. the linear isosurface in the cell is within the distance of the true one. Both conditions are checked for the
///    quadratic function through the values at corners and midpoints of edges. If the field has bounds, cells without
///    isosurfaces according to this function are also proven to have none, unless they touch a cell with one. Throws
///    Error{cannot_mesh} if more cells than allowed would be needed.
AdaptResult adapt(BackgroundMesh& mesh, const ScalarField& field, const std::vector<double>& values,
                  const AdaptLimits& limits);

/// Returns the linear function with these values at a tetrahedron's corners; its gradient is 0 if they are coplanar.
LinearFunction linear_in(const std::array<Vec3, 4>& corners, const std::array<double, 4>& values);

}  // namespace geomesh::geomodel
