// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Sealed structural models for recovery: horizons and faults that cross at low angles in a box of 16 x 9 x 5 km, made
/// valid by the arrangement, then given needle triangles in fans. Each model follows from its seed alone.
#pragma once

#include <cstddef>

#include "geomesh/core/plc.hpp"

namespace geomesh::geomodel::testing {

struct StructuralModelOptions {
  unsigned cells_along = 20;    ///< of a horizon, along the box's longest side
  double needle_share = 0.06;   ///< of all triangles, that have an angle below `needle_degrees`; reached nearly
  double least_spacing = 1e-5;  ///< m, of points put on lines where surfaces meet; log-uniform from here to 1 m
};
inline constexpr double needle_degrees = 0.1;

struct StructuralModel {
  PiecewiseLinearComplex plc;
  std::size_t n_needles = 0;
  double smallest_angle = 0;  ///< degrees
  double least_height = 0;    ///< m, of a triangle
};

/// Throws Error{cannot_mesh} where the arrangement refuses the surfaces. The model has been validated exactly
/// (validate_soup).
StructuralModel structural_model(unsigned seed, const StructuralModelOptions& options = {});

/// Cells along, share of needles and least spacing as they follow from the seed: 5,000 to 50,000 triangles; `family` 0
/// is small (a few thousand), 1 and 2 are larger.
StructuralModelOptions structural_options(unsigned seed, unsigned family);

}  // namespace geomesh::geomodel::testing
