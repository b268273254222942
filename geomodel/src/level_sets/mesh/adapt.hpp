// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Refines a background mesh until the isosurfaces in every cell are simple and nearly linear.
#pragma once

#include <cstddef>
#include <vector>

#include "level_sets/mesh/background_mesh.hpp"

namespace geomesh::geomodel {

struct AdaptLimits {
  double distance = 0;    ///< largest distance between the linear isosurface of a cell and that of the field
  double least_edge = 0;  ///< cells with all edges shorter than this are not refined
  /// Cells with all edges shorter than this are not refined if the only problem is that sheets are not resolved.
  double least_sheet_edge = 0;
  std::size_t most_cells = 0;
};

struct AdaptResult {
  /// Bounding boxes of cells at the least edge length in which an isosurface may have several sheets.
  std::vector<Box3> unresolved;
};

/// Bisects cells of the mesh where an isosurface of `values` (rising) may pass, until in each of them
/// 1. the field rises along one direction throughout, so that no isosurface has two sheets there (the small normal
///    variation of Plantinga and Vegter 2004), and
/// 2. the linear isosurface is within the distance.
/// Both are decided on the quadratic function through the values at corners and midpoints of edges. If the field has
/// bounds, cells without isosurfaces according to this function are also proven to have none, unless they touch a cell
/// with one. Throws Error{cannot_mesh} if more cells than allowed would be needed.
AdaptResult adapt(BackgroundMesh& mesh, const ScalarField& field, const std::vector<double>& values,
                  const AdaptLimits& limits);

/// Returns the linear function with these values at the corners; its gradient is 0 if the corners lie in a plane.
LinearFunction linear_in(const std::array<Vec3, 4>& corners, const std::array<double, 4>& values);

}  // namespace geomesh::geomodel
