// SPDX-License-Identifier: MIT
/// @file
/// Integrals of the inverse of a size over a mesh: how many elements a size field asks for, up to a constant.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>

#include "geomesh/core/size_field.hpp"
#include "remesh/domain/domain_mesh.hpp"

namespace geomesh::remesh {

struct SizeIntegrals {
  double volume = 0;   ///< over the cells, of 1 / size^3
  double surface = 0;  ///< over the constrained faces, each once, of 1 / size^2
  double fold = 0;     ///< along the curves at which two constrained faces meet, of 1 / size
};

/// The number of elements that sizes with these integrals take, where surfaces may be remeshed: within 30 % of what
/// scripts/element-counts prints for samples, templates and real sets, and for models of only a thousand elements.
double elements_of(const SizeIntegrals& integrals);

/// Cuts cells, faces and edges at their longest sides until sizes are even in each piece; pieces that bring less than a
/// ten-thousandth are sampled, which changes a sum by about a hundredth. Pieces of constant size are not cut, so a fine
/// even size costs no more than a coarse one. Nothing where the field grows away from so many small sizes that more
/// samples would be needed. A million samples take half a second. Five for each cell come on top of `most_samples`: one
/// for it and each of its faces. Ends where the elements are more than `enough`. The same result for the same input.
std::optional<SizeIntegrals> integrate_sizes(const DomainMesh& mesh, const SizeField& size, std::size_t most_samples,
                                             double enough = std::numeric_limits<double>::infinity());

}  // namespace geomesh::remesh
