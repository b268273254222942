// SPDX-License-Identifier: MIT
/// @file
/// Test-only readers of PLCs (OFF, OBJ, STL, ASCII PLY, TetGen .poly), so that the core's tests need no other room.
/// Equal points merge.
#pragma once

#include <string>

#include "geomesh/core/plc.hpp"

namespace geomesh::test {

/// By extension. Throws std::runtime_error for what it cannot read.
PiecewiseLinearComplex read_plc(const std::string& path);

}  // namespace geomesh::test
