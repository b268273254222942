// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Parts of a mesh for processors, by METIS.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver_mesh/face_sides.hpp"

namespace geomesh::geomodel {

/// What a part should have as much of as any other, and as little of as may be.
struct PartWeights {
  std::vector<double> of_cell;                 ///< by tetrahedron, 1 or more; empty: all alike
  std::vector<std::array<double, 4>> of_face;  ///< of the face to each neighbour, the same from both sides
};

/// The part of each tetrahedron, from 0: parts of about equal size that share few faces (Karypis and Kumar 1998). The
/// same mesh gives the same parts. `across`: as tetrahedra_across(). Throws Error{usage} where the program was built
/// without METIS, Error{cannot_mesh} where a part would have no tetrahedron.
std::vector<std::int32_t> parts_by_metis(const std::vector<Neighbours>& across, std::int32_t n_parts,
                                         const PartWeights& weights = {});

}  // namespace geomesh::geomodel
