// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Proves how far the triangles of an isosurface are from the true isosurface of the field.
///
/// A point p of a triangle is within d of the true isosurface if the field is below the value at p - d n and above it
/// at p + d n, for any unit vector n: a continuous field has the value somewhere between them. For a field with bounds
/// this is proven for all points of a triangle at once, on the two triangles shifted by d along n, which are subdivided
/// until the bounds decide. For other fields it is tested at samples.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "level_sets/mesh/isosurface.hpp"

namespace geomesh::geomodel {

/// Returns the rows of the triangles of an isosurface that are not proven to be within a distance of the true
/// isosurface. Precondition: the field has bounds.
std::vector<std::size_t> not_proven_within(const ScalarField& field, const Isosurface& surface, double value,
                                           double distance);

struct SampledDistance {
  std::size_t n_samples = 0;
  /// Rows of the triangles with at least one sample beyond the distance from the true isosurface, each listed once.
  std::vector<std::size_t> beyond;
};
/// Tests the distance of an isosurface at samples that are spread over it by area. The samples depend only on the
/// surface and on `seed`.
SampledDistance sample_within(const ScalarField& field, const Isosurface& surface, double value, double distance,
                              std::uint64_t seed);

}  // namespace geomesh::geomodel
