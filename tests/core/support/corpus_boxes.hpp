// SPDX-License-Identifier: MIT
/// @file
/// Random valid PLCs, from a seed: grids of warped boxes whose quadrilateral faces are cut by random diagonals (many a
/// box is then a Schoenhardt-like polyhedron), some faces left out, some triangles hung in boxes, stretched and turned
/// at random.
#pragma once

#include <cstdint>

#include "geomesh/core/plc.hpp"

namespace geomesh::test {

PiecewiseLinearComplex random_boxes(std::uint64_t seed);

}  // namespace geomesh::test
