// SPDX-License-Identifier: MIT
/// @file
/// Finds the bad cells of an unfinished mesh that the input does not impose, by the same criteria that are applied to
/// the result (unforced_bad_elements).
#pragma once

#include "geomesh/core/refine.hpp"
#include "remesh/passes/improve_passes.hpp"

namespace geomesh::remesh {

/// Creates the functions that find bad cells of a mesh imported from `input`, with sizes and patches as in `result`.
/// All arguments must outlive the returned object.
FreeCellJudge free_cell_judge(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& input,
                              const RefineOptions& options, const RefineResult& result);

}  // namespace geomesh::remesh
