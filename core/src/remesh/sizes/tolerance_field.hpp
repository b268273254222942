// SPDX-License-Identifier: MIT
/// @file
/// The distance from the input that is allowed by place, where it follows the sizes.
#pragma once

#include "geomesh/core/refine.hpp"
#include "remesh/domain/domain_mesh.hpp"
#include "remesh/tolerance/local_tolerance.hpp"

namespace geomesh::remesh {

/// Nothing where surfaces are kept. Else `options.tolerance` everywhere, or less: `options.tolerance_share` of the
/// size that the user asks for at the place, and half of the gap to the surface that faces it. That size is of the
/// whole model, units, surfaces, curves, places and background. `mesh` is the one that was given, before refinement.
LocalTolerance allowed_tolerance(const PiecewiseLinearComplex& plc, const DomainMesh& mesh,
                                 const RefineOptions& options);

}  // namespace geomesh::remesh
