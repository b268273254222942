// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Random valid piecewise linear complexes. The faces of any valid tetrahedral mesh, and any choice of them, are one:
/// so a random mesh is made, far from Delaunay, and some of its faces, edges and vertices are asked for.
#pragma once

#include <cstdint>

#include "geomesh/core/plc.hpp"

namespace geomesh::test {

/// Fixed by the seed. The hull's faces, or (one seed in four) a random part of the regions' faces that encloses
/// something, the faces between random regions, further single faces (they hang), single edges as segments, single
/// vertices. Points on a small integer grid (coplanar, cospherical) or at random, their vertices then moved at random
/// inside their stars (exactly checked) and the whole made flat in one direction. 20 to `max_points` points.
PiecewiseLinearComplex random_plc(std::uint64_t seed, unsigned max_points = 120);

/// As random_plc, with points all at random: no four coplanar, no five cospherical.
PiecewiseLinearComplex random_generic_plc(std::uint64_t seed, unsigned max_points = 120);

}  // namespace geomesh::test
