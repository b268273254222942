// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Refinement of a background mesh until the isosurfaces in it are simple and nearly linear in every cell.
#pragma once

#include <cstddef>
#include <vector>

#include "level_sets/mesh/background_mesh.hpp"

namespace geomesh::geomodel {

struct AdaptLimits {
  double distance = 0;          ///< at most this far may the linear isosurface of a cell be off the field's; a length
  double least_edge = 0;        ///< cells whose edges are all shorter are left as they are
  double least_sheet_edge = 0;  ///< and these too, where all that is wrong is that sheets are not told apart
  std::size_t most_cells = 0;
};

struct AdaptResult {
  std::vector<Box3> unresolved;  ///< bounds of cells at the least edge in which an isosurface may have several sheets
};

/// Bisects cells of the mesh where an isosurface of `values` (rising) may pass, until in each of them
/// 1. the field rises along one direction throughout, so that no isosurface has two sheets there (the small normal
///    variation of Plantinga and Vegter 2004), and
/// 2. the linear isosurface is within the distance.
/// Both are decided on the quadratic function through the values at corners and midpoints of edges. If the field has
/// bounds, cells that this function calls free of isosurfaces are proven free, unless they touch a cell with one.
/// Throws Error{cannot_mesh} where more cells than allowed would be needed.
AdaptResult adapt(BackgroundMesh& mesh, const ScalarField& field, const std::vector<double>& values,
                  const AdaptLimits& limits);

/// The linear function with these values at the corners; gradient 0 where the corners lie in a plane.
LinearFunction linear_in(const std::array<Vec3, 4>& corners, const std::array<double, 4>& values);

}  // namespace geomesh::geomodel
