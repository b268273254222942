// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Assigns parts of the sparse mesh to ranks.
#pragma once

#include <cstdint>
#include <vector>

#include "sparse_model.hpp"

namespace geomesh::app {

/// Returns the rank of each tetrahedron. Parts have about equally many elements; cuts follow surfaces where possible,
/// since triangles on surfaces exist on both sides anyway. Throws as geomodel::parts_by_metis.
std::vector<std::int32_t> divide(const SparseModel& model, int n_ranks);

}  // namespace geomesh::app
