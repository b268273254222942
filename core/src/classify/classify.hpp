// SPDX-License-Identifier: MIT
/// @file
/// Classification of cells as inside or outside by flood fill (Cavalcanti and Mello 1999, section 4), and conversion of
/// the result to plain arrays.
#pragma once

#include "geomesh/core/plc.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "recover/model/constrained_mesh.hpp"
#include "recover/model/declare.hpp"

namespace geomesh::classify {

/// Finds and numbers the components into which locked faces divide the recovered mesh, assigns the region seeds to
/// them, and drops the cells outside (see ConstrainedTetrahedralization). Throws Error{cannot_mesh} if nothing is
/// enclosed.
ConstrainedTetrahedralization classify(recover::ConstrainedMesh& mesh, recover::DeclaredModel& model,
                                       const PiecewiseLinearComplex& plc, const RunContext& context);

}  // namespace geomesh::classify
