// SPDX-License-Identifier: MIT
/// @file
/// Finds the bad cells of a mesh in work that the input does not impose, as users will see them in the result
/// (unforced_bad_elements).
#pragma once

#include "geomesh/core/refine.hpp"
#include "remesh/passes/improve_passes.hpp"

namespace geomesh::remesh {

/// For a mesh imported from `input`, with sizes and patches as in `result`. All of them must outlive the returned
/// object.
FreeCellJudge free_cell_judge(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& input,
                              const RefineOptions& options, const RefineResult& result);

}  // namespace geomesh::remesh
