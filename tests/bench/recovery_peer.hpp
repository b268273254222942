// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// One measured recovery, ours or TetGen's, in a process of its own on one core.
#pragma once

#include <string>

#include "geomesh/core/plc.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "measured_run.hpp"

namespace geomesh::bench {

/// CPU time of tetrahedralize() on one thread; then, in another process, the result is judged, and faults make the run
/// a failure.
Measurement measure_ours(const PiecewiseLinearComplex& plc, const TetrahedralizeOptions& options,
                         unsigned limit_seconds);
/// CPU time of TetGen's tetrahedralize() with the switches given, the conversion of the model left out.
Measurement measure_tetgen(const PiecewiseLinearComplex& plc, const std::string& switches, unsigned limit_seconds);

/// Triangles of the facets: corners less two, two more for each hole.
std::size_t n_triangles(const PiecewiseLinearComplex& plc);

}  // namespace geomesh::bench
