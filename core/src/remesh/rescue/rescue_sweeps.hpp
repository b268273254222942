// SPDX-License-Identifier: MIT
/// @file
/// Rescues over all bad cells of a mesh, again where something has changed since.
#pragma once

#include "remesh/rescue/free_cell_judge.hpp"
#include "remesh/rescue/rescue.hpp"

namespace geomesh::remesh {

using OutOfTime = std::function<bool()>;

/// What is still bad is mended by sequences of operations that look ahead.
void rescue_bad_cells(Toolbox& tools, const RescueRule& rule, const OutOfTime& out_of_time);

/// What is bad by our own doing, and not by the input's, is worth more: sequences that make the place worse at first,
/// and a search among these.
void rescue_free_cells(Toolbox& tools, const RescueRule& rule, const FreeCellJudge& judge,
                       const OutOfTime& out_of_time);

}  // namespace geomesh::remesh
