// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Merges patches of one fault before anything is intersected.
#pragma once

#include <vector>

#include "arrangement/snap/snap.hpp"

namespace geomesh::geomodel::arrangement {

/// Merges patches (sets of facets connected across edges) of one surface wherever they are closer to each other than
/// the distance. Faults are often given as patches that share no points, or that overlap along their seams. A patch is
/// not merged with itself, so that triangles smaller than the distance do not fold. `may_join` has an entry per
/// surface; `vertex_now` is as for snap_near(). O(n log n).
SnapOutcome join_patches(Complex& complex, const std::vector<std::uint8_t>& may_join, double distance,
                         const std::optional<Box3>& box, std::vector<VertexIndex>& vertex_now);

}  // namespace geomesh::geomodel::arrangement
