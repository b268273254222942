// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Which rank has which part of the sparse mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "sparse_model.hpp"

namespace geomesh::app {

/// By tetrahedron its rank. Parts come to about equally many elements; surfaces are cut rather than the inside, since
/// triangles on surfaces are there on both sides already. Throws as geomodel::parts_by_metis.
std::vector<std::int32_t> divide(const SparseModel& model, int n_ranks);

}  // namespace geomesh::app
