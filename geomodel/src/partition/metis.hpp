// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Divides a mesh into parts for several processors, with METIS.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver_mesh/face_sides.hpp"

namespace geomesh::geomodel {

/// Weights for dividing a mesh into parts. Each part gets about the same sum of cell weights, and the sum of the
/// weights of faces between parts is as small as possible.
struct PartWeights {
  std::vector<double> of_cell;  ///< weight of each tetrahedron, 1 or more; empty: all are equal
  /// For each tetrahedron, the cost of each of its faces if it separates two parts; the same on both sides of a face.
  std::vector<std::array<double, 4>> of_face;
};

/// Divides a mesh into parts of about equal size that share few faces (Karypis and Kumar 1998), and returns the part of
/// each tetrahedron, from 0. The same mesh gives the same parts. `across` is the result of tetrahedra_across(). Throws
/// Error{usage} if the program was built without METIS, Error{cannot_mesh} if a part would have no tetrahedron.
std::vector<std::int32_t> parts_by_metis(const std::vector<Neighbours>& across, std::int32_t n_parts,
                                         const PartWeights& weights = {});

}  // namespace geomesh::geomodel
