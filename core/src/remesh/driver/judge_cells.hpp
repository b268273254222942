// SPDX-License-Identifier: MIT
/// @file
/// Which bad cells of a mesh in work nothing of the input forces: judged as users will judge the result
/// (unforced_bad_elements).
#pragma once

#include "geomesh/core/refine.hpp"
#include "remesh/passes/improve_passes.hpp"

namespace geomesh::remesh {

/// For a mesh imported from `input` and sizes and patches as `result` has them. All of them must outlive what is
/// returned.
FreeCellJudge free_cell_judge(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& input,
                              const RefineOptions& options, const RefineResult& result);

}  // namespace geomesh::remesh
