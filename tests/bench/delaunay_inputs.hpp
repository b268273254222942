// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Point sets of the Delaunay benchmarks, shuffled, by fixed seeds.
#pragma once

#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::bench {

/// `uniform`: the unit cube. `horizons`: ten undulating surfaces, spacing much wider in x, y than in z. `clusters`:
/// spacings from 1e-7 to 1e4. `grid`: a cospherical lattice of about n points. `sphere`: on a sphere up to rounding.
/// `plane`, `line`: no volume. Throws std::invalid_argument on another name.
std::vector<Vec3> make_points(const std::string& name, std::size_t n, unsigned seed);

}  // namespace geomesh::bench
