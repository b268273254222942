// SPDX-License-Identifier: MIT
/// @file
/// Classification by flood fill (section 4 of the paper), and conversion of the result to plain arrays.
#pragma once

#include "geomesh/core/plc.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "recover/model/constrained_mesh.hpp"
#include "recover/model/declare.hpp"

namespace geomesh::classify {

/// Finds the components of the recovered mesh between its locked faces, numbers and seeds them, and drops the outside,
/// as ConstrainedTetrahedralization documents. Throws Error{cannot_mesh} if nothing is enclosed, and
/// Error{invalid_input} if a hole seed lies on a facet.
ConstrainedTetrahedralization classify(recover::ConstrainedMesh& mesh, recover::DeclaredModel& model,
                                       const PiecewiseLinearComplex& plc, const RunContext& context);

}  // namespace geomesh::classify
