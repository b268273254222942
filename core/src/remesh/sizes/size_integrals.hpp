// SPDX-License-Identifier: MIT
/// @file
/// Integrals of inverse powers of the size over a mesh. They determine how many elements a size field requires.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>

#include "geomesh/core/size_field.hpp"
#include "remesh/domain/domain_mesh.hpp"

namespace geomesh::remesh {

struct SizeIntegrals {
  double volume = 0;   ///< integral of 1 / size^3 over the cells
  double surface = 0;  ///< integral of 1 / size^2 over the constrained faces, each counted once
  double fold = 0;     ///< integral of 1 / size along curves at which two constrained faces meet
};

/// Returns the number of elements that these integrals require if surfaces may be remeshed. It is within 30 % of the
/// numbers printed by scripts/element-counts for samples, templates and real data sets, even for models of only a
/// thousand elements.
double elements_of(const SizeIntegrals& integrals);

/// Bisects cells, faces and edges at their longest edge until sizes are nearly constant in each piece. Pieces that
/// contribute less than a ten-thousandth are sampled, which changes a sum by about a hundredth. Pieces of constant size
/// are not bisected, so a uniform fine size costs no more than a coarse one. Returns nothing if more than
/// `most_samples` samples would be needed, in addition to five for each cell (one for it and one for each face). A
/// million samples take half a second. Ends early if there are more than `enough` elements. The same input always gives
/// the same result.
std::optional<SizeIntegrals> integrate_sizes(const DomainMesh& mesh, const SizeField& size, std::size_t most_samples,
                                             double enough = std::numeric_limits<double>::infinity());

}  // namespace geomesh::remesh
