// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Parts of a mesh for processors, by METIS.
#pragma once

#include <cstdint>
#include <vector>

#include "solver_mesh/face_sides.hpp"

namespace geomesh::geomodel {

/// The part of each tetrahedron, from 0: parts of about equal size that share few faces (Karypis and Kumar 1998). The
/// same mesh gives the same parts. `across`: as tetrahedra_across(). Throws Error{usage} where the program was built
/// without METIS, Error{cannot_mesh} where a part would have no tetrahedron.
std::vector<std::int32_t> parts_by_metis(const std::vector<Neighbours>& across, std::int32_t n_parts);

}  // namespace geomesh::geomodel
