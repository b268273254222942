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
};

/// Cuts cells and faces at their longest sides until sizes are even in each piece; pieces that bring less than an
/// element are sampled, which changes a sum of N elements by about its square root. Pieces of constant size are not
/// cut, so a fine even size costs no more than a coarse one. Nothing where the field grows away from so many small
/// sizes that more samples would be needed. A million samples take half a second. Five for each cell come on top of
/// `most_samples`: one for it and each of its faces. Ends where either integral is more than `enough`. The same result
/// for the same input.
std::optional<SizeIntegrals> integrate_sizes(const DomainMesh& mesh, const SizeField& size, std::size_t most_samples,
                                             const SizeIntegrals& enough = {std::numeric_limits<double>::infinity(),
                                                                            std::numeric_limits<double>::infinity()});

}  // namespace geomesh::remesh
