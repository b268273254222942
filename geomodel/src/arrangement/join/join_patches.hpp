// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Merges patches of one fault before anything is intersected.
#pragma once

#include <vector>

#include "arrangement/snap/snap.hpp"

namespace geomesh::geomodel::arrangement {

/// A patch is connected across edges. Patches of one surface are merged wherever they are closer to each other than the
/// distance: faults come in patches that share no points, or overlap along their seams. A patch is not merged with
/// itself, so that triangles smaller than the distance do not fold. `may_join` is by surface. `vertex_now` as for
/// snap_near(). O(n log n).
SnapOutcome join_patches(Complex& complex, const std::vector<std::uint8_t>& may_join, double distance,
                         const std::optional<Box3>& box, std::vector<VertexIndex>& vertex_now);

}  // namespace geomesh::geomodel::arrangement
