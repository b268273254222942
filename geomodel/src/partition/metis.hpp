// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Divides a mesh into parts for processors with METIS.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver_mesh/face_sides.hpp"

namespace geomesh::geomodel {

/// Weights of cells and faces. Each part gets about the same sum of cell weights, and as little as possible of face
/// weights is cut.
struct PartWeights {
  std::vector<double> of_cell;                 ///< weight by tetrahedron, 1 or more; empty: all equal
  std::vector<std::array<double, 4>> of_face;  ///< weight of the face to each neighbour, the same from both sides
};

/// Returns the part of each tetrahedron, from 0: parts of about equal size that share few faces (Karypis and Kumar
/// 1998). The same mesh gives the same parts. `across` as from tetrahedra_across(). Throws Error{usage} if the program
/// was built without METIS, Error{cannot_mesh} if a part would have no tetrahedron.
std::vector<std::int32_t> parts_by_metis(const std::vector<Neighbours>& across, std::int32_t n_parts,
                                         const PartWeights& weights = {});

}  // namespace geomesh::geomodel
