// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Assigns parts of the sparse mesh to ranks.
#pragma once

#include <cstdint>
#include <vector>

#include "sparse_model.hpp"

namespace geomesh::app {

/// Divides the sparse mesh among the ranks and returns the rank of each tetrahedron. Parts have about equally many
/// elements. Borders between parts follow surfaces if possible, since triangles on surfaces are kept anyway.
std::vector<std::int32_t> divide(const SparseModel& model, int n_ranks);

}  // namespace geomesh::app
