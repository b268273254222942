// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// How far the triangles of an isosurface are from where the field has the value.
///
/// A point p of a triangle is within d of the true isosurface if the field is below the value at p - d n and above it
/// at p + d n, for any unit vector n: a continuous field has the value somewhere between. For a field with bounds this
/// is proven for all points of a triangle at once, on the two triangles moved by d along n, which are divided until the
/// bounds decide. For other fields it is found for samples.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "level_sets/mesh/isosurface.hpp"

namespace geomesh::geomodel {

/// Triangles that are not proven to be within the distance, by row. Precondition: the field has bounds.
std::vector<std::size_t> not_proven_within(const ScalarField& field, const Isosurface& surface, double value,
                                           double distance);

struct SampledDistance {
  std::size_t n_samples = 0;
  std::vector<std::size_t> beyond;  ///< triangles with a sample that is not within the distance; each once
};
/// Samples spread over the surface by area, at places that depend on the surface and `seed` alone.
SampledDistance sample_within(const ScalarField& field, const Isosurface& surface, double value, double distance,
                              std::uint64_t seed);

}  // namespace geomesh::geomodel
